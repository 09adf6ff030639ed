// Tables against time: values between rows, jumps, ends, and integrals that no rounding of long tables
// spoils.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "sim/error.h"
#include "sim/terrain/time_series.h"

namespace talus::time_series_test {
namespace {

TEST(TimeSeries, IsLinearBetweenRowsAndLevelBeyondThem) {
    const TimeSeries series({{10, 2}, {20, 6}, {40, 0}});
    EXPECT_EQ(series.at(-5), 2);
    EXPECT_EQ(series.at(10), 2);
    EXPECT_EQ(series.at(12.5), 3);
    EXPECT_EQ(series.at(20), 6);
    EXPECT_EQ(series.at(30), 3);
    EXPECT_EQ(series.at(1e9), 0);
    EXPECT_EQ(series.lowest(), 0);
    EXPECT_EQ(series.highest(), 6);
    EXPECT_EQ(TimeSeries().at(3), 0);
}

TEST(TimeSeries, TwoRowsOfOneTimeAreAJump) {
    const TimeSeries series({{0, 1}, {5, 1}, {5, 3}, {10, 3}});
    EXPECT_EQ(series.at(4.999), 1);
    EXPECT_EQ(series.at(5), 3);
    EXPECT_DOUBLE_EQ(series.integral(0, 10), 20);
    EXPECT_DOUBLE_EQ(series.mean(4, 6), 2);
    EXPECT_EQ(series.mean(5, 5), 3);
}

TEST(TimeSeries, IntegratesFromBeforeItsFirstRowToBehindItsLast) {
    const TimeSeries series({{10, 2}, {20, 6}});
    EXPECT_DOUBLE_EQ(series.integral(0, 10), 20);
    EXPECT_DOUBLE_EQ(series.integral(0, 30), 20 + 40 + 60);
    EXPECT_DOUBLE_EQ(series.integral(15, 16), 4.2);
    EXPECT_DOUBLE_EQ(series.integral(25, 30), 30);
    EXPECT_DOUBLE_EQ(TimeSeries({{0, 4}}).integral(-3, 5), 32);
}

// Against the sum of fine trapezoids, over spans that begin and end anywhere.
TEST(TimeSeries, IntegralsAreThoseOfTheCurve) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<TimeSeries::Row> rows;
    for (double time_s = 0; rows.size() < 200; time_s += unit(random) * unit(random))
        rows.push_back({time_s, 10 * unit(random)});
    const TimeSeries series(rows);
    for (int trial = 0; trial < 50; ++trial) {
        const double from_s = -2 + 50 * unit(random);
        const double to_s = from_s + 20 * unit(random);
        constexpr int parts = 100000;
        double sum = 0;
        for (int i = 0; i < parts; ++i) sum += series.at(from_s + (to_s - from_s) * (i + 0.5) / parts);
        const double found = sum * (to_s - from_s) / parts;
        EXPECT_NEAR(series.integral(from_s, to_s), found, 1e-4 * std::max(found, 1.0));
    }
}

TEST(TimeSeries, TheMeanStaysWithinWhatTheTableHolds) {
    const TimeSeries series({{0, 0.1}, {1e6, 0.1}});
    for (double time_s = 0; time_s < 100; time_s += 0.37) EXPECT_EQ(series.mean(time_s, time_s + 0.1), 0.1);
}

TEST(TimeSeries, RefusesWhatIsNoTable) {
    EXPECT_THROW(TimeSeries(std::vector<TimeSeries::Row>()), Error);
    EXPECT_THROW(TimeSeries({{0, 1}, {-1, 1}}), Error);
    EXPECT_THROW(TimeSeries({{0, std::nan("")}}), Error);
    EXPECT_THROW(TimeSeries({{0, 1}, {std::numeric_limits<double>::infinity(), 1}}), Error);
}

}  // namespace
}  // namespace talus::time_series_test
