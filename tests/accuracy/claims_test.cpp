// What `talus verify` checks on a user's device holds on this one.
#include "app/claims/claims.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "sim/gpu/context.h"

namespace talus::claims_test {
namespace {

class Claims : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Claims, Hold) {
    const gpu::Context context;
    const claims::Verdict verdict = claims::verdict_on(claims::claims()[GetParam()]);
    std::printf("%s: %.3g %s, at most %.3g, %.1f s\n", verdict.name.c_str(), verdict.finding.figure,
                verdict.finding.unit.c_str(), verdict.finding.bound, verdict.seconds);
    EXPECT_TRUE(verdict.holds()) << verdict.error;
}

INSTANTIATE_TEST_SUITE_P(All, Claims, ::testing::Range<std::size_t>(0, claims::claims().size()),
                         [](const auto& claim) {
                             std::string name = claims::claims()[claim.param].name;
                             for (char& letter : name)
                                 if (letter == ' ' || letter == ',') letter = '_';
                             return name;
                         });

}  // namespace
}  // namespace talus::claims_test
