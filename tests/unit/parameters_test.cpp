// Parameters, presets: what is refused, in which words, and what round-trips.
#include <gtest/gtest.h>

#include <map>

#include "app/core/app_parameters.h"
#include "render/view.h"
#include "sim/error.h"
#include "sim/passes/thermal_settings.h"
#include "sim/passes/water_settings.h"
#include "sim/preset.h"

namespace talus::parameters_test {
namespace {

std::string error_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Parameters, RefuseInOneSentenceThatNamesTheParameter) {
    Parameters p(app::all_parameters());
    EXPECT_EQ(error_of([&] { p.set_assignment("thermal.repose_deg=95"); }),
              "thermal.repose_deg = 95 is out of range, it must be 1 to 80 °");
    EXPECT_EQ(error_of([&] { p.set_assignment("thermal.repose_deg=nan"); }),
              "thermal.repose_deg = nan is out of range, it must be 1 to 80 °");
    EXPECT_EQ(error_of([&] { p.set_assignment("thermal.on=7"); }),
              "thermal.on cannot be '7', it must be true or false");
    EXPECT_EQ(error_of([&] { p.set_assignment("terrain.seed=1.5"); }),
              "terrain.seed cannot be '1.5', it must be a whole number");
    EXPECT_EQ(error_of([&] { p.set_assignment("brush.material=x"); }),
              "brush.material cannot be 'x', it must be one of: bedrock, regolith");
    EXPECT_EQ(error_of([&] { p.set_assignment("no.such=1"); }),
              "there is no parameter 'no.such', 'talus parameters' lists them");
    EXPECT_EQ(error_of([&] { p.set_assignment("thermal.on"); }),
              "'thermal.on' sets nothing, write it as section.name=value");
    EXPECT_EQ(p, Parameters(app::all_parameters()));
}

TEST(Parameters, EveryOneIsDeclaredWithHelpAndItsDefaultIsAllowed) {
    for (const Parameter& parameter : app::all_parameters()) {
        Parameters p(app::all_parameters());
        EXPECT_NO_THROW(p.set(parameter.name, parameter.preset)) << parameter.name;
        EXPECT_FALSE(parameter.help.empty()) << parameter.name;
        EXPECT_NE(parameter.name.find('.'), std::string::npos) << parameter.name;
    }
}

// Beside a value there is room for so many letters.
TEST(Parameters, HaveLabelsInPlainWords) {
    std::map<std::pair<std::string, std::string>, std::string> seen;
    for (const Parameter& p : app::all_parameters()) {
        const std::string label = label_of(p);
        EXPECT_LE(label.size(), 20U) << p.name << ": " << label;
        EXPECT_TRUE(label[0] >= 'A' && label[0] <= 'Z') << p.name << ": " << label;
        EXPECT_EQ(label.find('_'), std::string::npos) << p.name;
        EXPECT_TRUE(p.choice_labels.empty() || p.choice_labels.size() == p.choices.size()) << p.name;
        for (const std::string& choice : p.choices)
            EXPECT_EQ(label_of_choice(p, choice).find('_'), std::string::npos) << p.name << ": " << choice;
        // In a panel two that are called alike could not be told apart; of the scales of views one is shown.
        const std::string section = p.name.substr(0, p.name.find('.'));
        if (section == "render") continue;
        const auto [other, is_new] = seen.emplace(std::pair(section, label), p.name);
        EXPECT_TRUE(is_new) << p.name << " and " << other->second << " are both called " << label;
    }
}

TEST(Parameters, ValuesAreWrittenAsPeopleWriteThem) {
    const Parameters p(app::all_parameters());
    EXPECT_EQ(value_text(p.declaration("thermal.repose_deg"), 35.0), "35 °");
    EXPECT_EQ(value_text(p.declaration("water.inflow_m3_per_s"), 1e7), "10000000 m³/s");
    EXPECT_EQ(value_text(p.declaration("render.samples"), 8), "8");
    EXPECT_EQ(value_text(p.declaration("water.on"), true), "on");
    EXPECT_EQ(value_text(p.declaration("render.view"), std::string("largest_depth")), "Largest depth");
}

// Also after units were converted there and back.
TEST(Parameters, HaveTheDefaultsOfTheSettingsThatTheySet) {
    const Parameters p(app::all_parameters());
    EXPECT_EQ(bound_settings(water_parameters(), p), WaterSettings());
    EXPECT_EQ(bound_settings(sediment_parameters(), p), SedimentSettings());
    EXPECT_EQ(bound_settings(thermal_parameters(), p), ThermalSettings());
    EXPECT_EQ(p.number("water.manning"), 0.03);
    EXPECT_EQ(p.number("erosion.settling_mm_per_s"), 10);
    EXPECT_EQ(p.number("erosion.bedrock_erodibility"), 0.1);
}

TEST(Parameters, SayTheirUnitsInTheirNames) {
    int with_unit = 0;
    for (const Parameter& parameter : app::all_parameters()) {
        const std::string unit = unit_in_name(parameter.unit);
        EXPECT_TRUE(parameter.name.ends_with(unit)) << parameter.name << " in " << parameter.unit;
        with_unit += unit.empty() ? 0 : 1;
    }
    EXPECT_GT(with_unit, 50);
}

TEST(Parameters, GoByTheirOldNamesToo) {
    Parameters p(app::all_parameters());
    Parameters q(app::all_parameters());
    int old = 0;
    for (const Parameter& parameter : app::all_parameters()) {
        if (parameter.old_name.empty()) continue;
        ++old;
        p.set(parameter.name, parameter.high / 2);
        q.set(parameter.old_name, parameter.high / 2);
        EXPECT_TRUE(q.is_given(parameter.name)) << parameter.name;
        EXPECT_EQ(q.value(parameter.old_name), p.value(parameter.name));
    }
    EXPECT_EQ(old, 19);
    EXPECT_EQ(p, q);
    EXPECT_EQ(to_toml(p), to_toml(q));
}

TEST(Parameters, OfOldPresetsAreRead) {
    Parameters p(app::all_parameters());
    from_toml("[water]\nrain = 150.0\n[erosion]\nsettling = 5\n[brush]\nrain = 20.0\n", "old.toml", p);
    EXPECT_EQ(p.number("water.rain_mm_per_h"), 150);
    EXPECT_EQ(p.number("erosion.settling_mm_per_s"), 5);
    EXPECT_EQ(p.number("brush.rain_mm_per_h"), 20);
}

// What panels show: parameters of the method and of the view that are chosen, and of no others.
TEST(ViewSettings, HeedWhatTheChosenMethodAndViewDeclare) {
    Parameters drawing(render::render_parameters());
    for (const render::MethodEntry& chosen : render::methods()) {
        drawing.set("render.method", chosen.name);
        for (const render::MethodEntry& method : render::methods())
            for (const Parameter& own : method.parameters)
                EXPECT_EQ(render::is_heeded(own.name, drawing, false), method.name == chosen.name)
                    << own.name << ", " << chosen.name;
        EXPECT_EQ(render::is_heeded("render.tolerance_px", drawing, false), chosen.heeds_tolerance)
            << chosen.name;
        EXPECT_TRUE(render::is_heeded("render.method", drawing, false));
    }
    drawing.set("render.view", std::string("depth"));
    EXPECT_TRUE(render::is_heeded("render.depth_m", drawing, false));
    EXPECT_FALSE(render::is_heeded("render.band_m", drawing, false));
    drawing.set("render.view", std::string("shaded"));
    EXPECT_FALSE(render::is_heeded("render.texture_taps", drawing, false));
    EXPECT_TRUE(render::is_heeded("render.texture_taps", drawing, true));
    EXPECT_TRUE(render::is_heeded("material.snow_line_m", drawing, false));
    EXPECT_FALSE(render::is_heeded("material.snow_line_m", drawing, true))
        << "a picture lies over the ground";
    EXPECT_TRUE(render::is_heeded("material.clarity", drawing, true));
    // Two views share one.
    drawing.set("render.view", std::string("largest_depth"));
    EXPECT_TRUE(render::is_heeded("render.depth_m", drawing, false));
}

// What a view shows hangs on the simulation's gravity, and on its own scale.
TEST(ViewSettings, TakeGravityAndTheScalesOfAllViews) {
    Parameters p(app::all_parameters());
    p.set("water.gravity_m_per_s2", 3.7);
    for (const render::View& view : render::views())
        for (const render::ViewNumber& one : view.numbers)
            if (one.parameter && std::holds_alternative<double>(one.parameter->preset))
                p.set(one.parameter->name, one.parameter->high / 8);
            else if (one.parameter && std::holds_alternative<int>(one.parameter->preset))
                p.set(one.parameter->name, static_cast<int>(one.parameter->high / 8));
    p.set("render.hillshade", std::string("four sides"));
    const render::ViewSettings settings = render::view_settings(p, p);
    EXPECT_EQ(settings.gravity_m_per_s2, 3.7);
    for (const render::View& view : render::views())
        for (const render::ViewNumber& one : view.numbers) {
            if (one.uniform == "hillshade_from")
                EXPECT_EQ(one.in(settings), 1);
            else if (one.parameter)
                EXPECT_EQ(one.in(settings), one.parameter->high / 8) << one.uniform;
            else
                EXPECT_EQ(one.in(settings), one.fixed);
        }
}

TEST(Parameters, FollowOthersUnlessSet) {
    Parameters p(app::all_parameters());
    p.set("thermal.repose_deg", 40.0);
    EXPECT_EQ(p.number("thermal.wet_deg"), 40);
    EXPECT_FALSE(p.is_given("thermal.wet_deg"));
    p.set("thermal.wet_deg", 20.0);
    p.set("thermal.repose_deg", 30.0);
    EXPECT_EQ(p.number("thermal.wet_deg"), 20);
    EXPECT_EQ(p.number("thermal.bedrock_deg"), 30);
    p.reset("thermal.wet_deg");
    EXPECT_EQ(p.number("thermal.wet_deg"), 30);
    p.reset("thermal.repose_deg");
    EXPECT_EQ(p.number("thermal.wet_deg"), 33);
}

TEST(Presets, AllBuiltInOnesApply) {
    const std::vector<Preset> presets = built_in_presets();
    ASSERT_EQ(presets.size(), 13U);
    for (const Preset& preset : presets) {
        Parameters p(app::all_parameters());
        EXPECT_NO_THROW(apply_preset(preset, p)) << preset.name;
        EXPECT_FALSE(preset.description.empty());
    }
}

TEST(Presets, RefuseUnknownKeysAndWrongTypesAndChangeNothing) {
    Parameters p(app::all_parameters());
    const auto apply = [&](const std::string& text) {
        return error_of([&] { from_toml(text, "my.toml", p); });
    };
    EXPECT_EQ(apply("[thermal]\nrepose_deg = 30.0\nspeed = 1\n"),
              "my.toml: there is no parameter 'thermal.speed', 'talus parameters' lists them");
    EXPECT_EQ(apply("[thermal]\nrepose_deg = \"steep\"\n"),
              "my.toml: thermal.repose_deg cannot be 'steep', it must be a number");
    EXPECT_EQ(apply("[thermal]\nrepose_deg = [1]\n"),
              "my.toml: thermal.repose_deg must be a number, a text or true or false");
    EXPECT_EQ(
        apply("colour = 1\n"),
        "my.toml: unknown key 'colour', only title, description, [sections] and [[event]] stand at the top");
    EXPECT_NE(apply("[thermal\n").find("my.toml: line 1 is not TOML"), std::string::npos);
    EXPECT_EQ(p, Parameters(app::all_parameters()));
}

TEST(Presets, TomlKeepsEveryBit) {
    Parameters p(app::all_parameters());
    p.set("thermal.rate_m2_per_s", 1.0 / 3.0);
    p.set("time.tick_s", 0.1 + 0.2);
    p.set("thermal.repose_deg", 30.0);
    p.set("terrain.kind", std::string("hills"));
    Parameters q(app::all_parameters());
    from_toml(to_toml(p), "text", q);
    EXPECT_EQ(p, q);
}

}  // namespace
}  // namespace talus::parameters_test
