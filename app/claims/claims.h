#pragma once
#include <functional>
#include <string>
#include <vector>

namespace talus::claims {

/// What was found of a claim: a figure, and the bound that it must not exceed.
struct Finding {
    double figure = 0;
    double bound = 0;
    std::string unit;
    bool holds() const { return figure <= bound; }  // not where it is no number
};

/// Something that Talus says of its numbers, and how it is checked on the present context, within seconds.
struct Claim {
    std::string name;
    std::string says;
    std::function<Finding()> check;
};

/// All of them, those of which others are made first: passes against their twins, pictures against the
/// surface in double, what is kept against what is made anew, undo and journal, exact solutions, books. A new
/// one is a line here.
const std::vector<Claim>& claims();

/// A claim as it was found.
struct Verdict {
    std::string name;
    std::string says;
    Finding finding;
    std::string error;  ///< what was thrown instead of a finding; empty: nothing
    double seconds = 0;
    bool holds() const { return error.empty() && finding.holds(); }
};
/// Checks it. Throws nothing: what is thrown is a verdict too.
Verdict verdict_on(const Claim& claim);

}  // namespace talus::claims
