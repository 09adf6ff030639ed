// What a hand's stroke does follows from where it went and for how long, not from how many frames that took.
#include <gtest/gtest.h>

#include "app/core/app_parameters.h"
#include "app/tools/brush_stroke.h"

namespace talus::brush_stroke_test {
namespace {

Parameters view(const std::string& tool) {
    Parameters parameters(app::app_parameters());
    parameters.set("brush.tool", tool);
    parameters.set("brush.radius_m", 100.0);
    return parameters;
}

double metres(const std::vector<Dab>& dabs) {
    double sum = 0;
    for (const Dab& dab : dabs) sum += dab.amount_m;
    return sum;
}

TEST(BrushStroke, TakesTheSameTimeInFewFramesAndInMany) {
    const Parameters parameters = view("raise");
    for (const int frames : {1, 7, 60}) {
        app::BrushStroke stroke(parameters, {}, {0, 0, 500}, 0);
        std::vector<Dab> dabs;
        for (int i = 1; i <= frames; ++i)
            for (const Dab& dab :
                 stroke.move(parameters, {800.0 * i / frames, 0, 500}, 2.0 / frames, nullptr))
                dabs.push_back(dab);
        EXPECT_NEAR(metres(dabs), 2 * parameters.number("brush.rate_m_per_s"), 1e-9) << frames;
        EXPECT_GE(dabs.size(), 32U) << frames << ": a quarter radius apart at most";
        EXPECT_EQ(dabs.back().x_m, 800);
        for (std::size_t i = 1; i < dabs.size(); ++i) EXPECT_LE(dabs[i].x_m - dabs[i - 1].x_m, 25.001);
    }
}

TEST(BrushStroke, BlendsAddUpToTheSameShare) {
    const Parameters parameters = view("smooth");
    for (const int frames : {1, 10, 100}) {
        app::BrushStroke stroke(parameters, {}, {0, 0, 0}, 0);
        double left = 1;
        for (int i = 0; i < frames; ++i)
            for (const Dab& dab : stroke.move(parameters, {0, 0, 0}, 0.5 / frames, nullptr))
                left *= 1 - dab.blend;
        EXPECT_NEAR(left, std::exp(-0.5 * parameters.number("brush.blend_per_s")), 1e-9) << frames;
    }
}

TEST(BrushStroke, ErodesForAsLongAsItIsHeldWithOneWater) {
    Parameters parameters = view("erode");
    parameters.set("erode.speed", 50.0);
    for (const int frames : {1, 9, 40}) {
        app::BrushStroke stroke(parameters, {}, {0, 0, 0}, 0);
        std::vector<Dab> dabs;
        for (int i = 1; i <= frames; ++i)
            for (const Dab& dab : stroke.move(parameters, {90.0 * i / frames, 0, 0}, 2.0 / frames, nullptr))
                dabs.push_back(dab);
        const std::optional<Dab> last = stroke.end(parameters);
        ASSERT_TRUE(last);
        double time_s = 0;
        for (const Dab& dab : dabs) time_s += dab.as<ErodeDab>()->time_s;
        EXPECT_NEAR(time_s, 100, 1e-9);
        EXPECT_LT(last->as<ErodeDab>()->time_s, 0.01);
        EXPECT_EQ(last->x_m, 90);
        for (std::size_t i = 0; i < dabs.size(); ++i) {
            EXPECT_EQ(dabs[i].as<ErodeDab>()->begins, i == 0);
            EXPECT_FALSE(dabs[i].as<ErodeDab>()->ends);
        }
        EXPECT_FALSE(last->as<ErodeDab>()->begins);
        EXPECT_TRUE(last->as<ErodeDab>()->ends);
    }
}

// Keys that are pressed under a stroke: erosion goes on as it began, for its water has one size and one
// strength; other strokes take a new size, and none another tool.
TEST(BrushStroke, KeepsItsTool) {
    Parameters parameters = view("erode");
    app::BrushStroke erosion(parameters, {}, {0, 0, 0}, 0);
    erosion.move(parameters, {10, 0, 0}, 0.1, nullptr);
    Parameters others = view("raise");
    others.set("brush.radius_m", 300.0);
    others.set("erode.acceleration", 7.0);
    for (const Dab& dab : erosion.move(others, {20, 0, 0}, 0.1, nullptr)) {
        EXPECT_EQ(dab.mode(), BrushMode::erode);
        EXPECT_EQ(dab.radius_m, 100);
        EXPECT_EQ(dab.as<ErodeDab>()->acceleration, parameters.number("erode.acceleration"));
    }
    ASSERT_TRUE(erosion.end(others));
    EXPECT_EQ(erosion.end(others)->mode(), BrushMode::erode);
    app::BrushStroke raise(view("raise"), {}, {0, 0, 0}, 0);
    for (const Dab& dab : raise.move(parameters, {20, 0, 0}, 0.1, nullptr))
        EXPECT_EQ(dab.mode(), BrushMode::raise);
    for (const Dab& dab : raise.move(others, {30, 0, 0}, 0.1, nullptr)) EXPECT_EQ(dab.radius_m, 300);
    EXPECT_FALSE(raise.end(parameters));
}

TEST(BrushStroke, CtrlTurnsAroundAndShiftSmooths) {
    const auto dab = [](const std::string& tool, const app::Modifiers& modifiers) {
        return tool_dab(view(tool), modifiers, 12, 1, nullptr);
    };
    EXPECT_EQ(dab("raise", {true, false}).mode(), BrushMode::lower);
    EXPECT_EQ(dab("lower", {true, false}).mode(), BrushMode::raise);
    EXPECT_EQ(dab("raise", {false, true}).mode(), BrushMode::smooth);
    EXPECT_EQ(dab("mask", {false, true}).mode(), BrushMode::smooth);
    EXPECT_LT(dab("noise", {true, false}).amount_m, 0);
    EXPECT_EQ(dab("mask", {true, false}).target_m, 0);
    EXPECT_TRUE(dab("water", {true, false}).is_water());
    EXPECT_EQ(dab("flatten", {}).target_m, 12);
    for (const std::string& tool : app::tool_names())
        for (const bool inverted : {false, true})
            for (const bool smooth : {false, true})
                EXPECT_NO_THROW(check_dab(dab(tool, {inverted, smooth}))) << tool;
}

TEST(BrushStroke, StampsStandASpacingApart) {
    Parameters parameters = view("stamp");
    parameters.set("brush.spacing", 2.0);
    app::BrushStroke stroke(parameters, {}, {0, 0, 0}, 0);
    std::vector<Dab> dabs;
    for (int i = 1; i <= 100; ++i)
        for (const Dab& dab : stroke.move(parameters, {10.0 * i, 0, 0}, 0.01, nullptr)) dabs.push_back(dab);
    ASSERT_EQ(dabs.size(), 6U);
    for (std::size_t i = 0; i < dabs.size(); ++i) EXPECT_NEAR(dabs[i].x_m, 200.0 * i, 1e-6);
}

TEST(BrushStroke, ARampIsOneDabFromItsBeginningToItsEnd) {
    const Parameters parameters = view("ramp");
    app::BrushStroke stroke(parameters, {}, {100, 200, 50}, 0);
    EXPECT_TRUE(stroke.move(parameters, {300, 250, 90}, 0.5, nullptr).empty());
    const std::optional<Dab> dab = stroke.end(parameters);
    ASSERT_TRUE(dab);
    EXPECT_EQ(dab->way_m(), glm::dvec2(200, 50));
    EXPECT_EQ(dab->target_m, 50);
    EXPECT_EQ(dab->as<RampDab>()->rise_m, 40);
}

TEST(BrushStroke, JitterIsTheSameForTheSameSeedAndStroke) {
    Parameters parameters = view("raise");
    parameters.set("brush.jitter", 0.5);
    const auto places = [&](unsigned number) {
        app::BrushStroke stroke(parameters, {}, {0, 0, 0}, number);
        std::vector<glm::dvec2> found;
        for (const Dab& dab : stroke.move(parameters, {500, 0, 0}, 1, nullptr))
            found.emplace_back(dab.x_m, dab.y_m);
        return found;
    };
    EXPECT_EQ(places(3), places(3));
    EXPECT_NE(places(3), places(4));
    for (const glm::dvec2& place : places(3)) EXPECT_LE(std::abs(place.y), 50);
}

}  // namespace
}  // namespace talus::brush_stroke_test
