#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace talus {

/// A parameter's value: a switch, a whole number, a number, or one of the declared choices by name.
using Value = std::variant<bool, int, double, std::string>;

/// What else a change of a parameter sets off in a simulation, beside its new value.
enum class SetsOff {
    nothing,
    solid_weights,  ///< regolith or load count otherwise as solid: the ledger books the difference
    sea,        ///< when set, the sea fills what lies lower; set again at once, it takes the place of that
    edge_clock  ///< inflow and wave maker begin anew
};

/// How a number follows a table against time (sim/drives.h).
enum class Driven {
    by_tick,      ///< in each tick it is the table's mean over that tick
    within_tick,  ///< its pass reads the table within the tick, and wakes what that moves
    never         ///< it holds for a whole run, or a change of it is an act of its own
};

/// One declared parameter (law 8): panels, preset keys, --set, help and the docs come from it.
struct Parameter {
    std::string name;  ///< section.name
    Value preset;      ///< the default; its type is the parameter's type
    double low = 0;    ///< numbers: smallest allowed
    double high = 0;   ///< numbers: largest allowed
    std::string unit;
    std::string help;
    std::vector<std::string> choices;  ///< names, for text parameters
    std::string old_name = "";         ///< as files of earlier versions have it; it is still read
    std::string follows = "";          ///< unless set, its value is that of the number parameter of this name
    SetsOff sets_off = SetsOff::nothing;
    Driven driven = Driven::by_tick;
    bool of_machine = false;  ///< it is about the machine, and not kept in projects
    std::string label = "";   ///< what a person reads beside its value; empty: its name tells that
    std::vector<std::string> choice_labels = {};  ///< the same of its choices; empty: their names do

    Parameter once(std::string name) &&;
    Parameter following(std::string name) &&;
    Parameter setting_off(SetsOff what) &&;
    Parameter following_tables(Driven how) &&;
    Parameter of_this_machine() &&;
    Parameter labelled(std::string words) &&;
    /// In the order of its choices, one each.
    Parameter choices_labelled(std::vector<std::string> words) &&;
};

Parameter number(std::string name, double preset, double low, double high, std::string unit,
                 std::string help);
Parameter whole(std::string name, int preset, int low, int high, std::string unit, std::string help);
Parameter toggle(std::string name, bool preset, std::string help);
Parameter choice(std::string name, std::string preset, std::vector<std::string> choices, std::string help);
/// The same by the preset's place among the choices: of an enum whose values stand in their order, or a
/// switch.
template <typename Enum>
requires std::is_enum_v<Enum> || std::is_same_v<Enum, bool> Parameter choice(std::string name, Enum preset,
                                                                             std::vector<std::string> choices,
                                                                             std::string help) {
    std::string chosen = choices.at(static_cast<std::size_t>(preset));
    return choice(std::move(name), std::move(chosen), std::move(choices), std::move(help));
}

/// How a name says that its number has this unit: "_m_per_s" of m/s, "_mm_per_h" of mm/h, "_deg" of °. Empty
/// for units that names leave out: counts, ratios (s/s), and those that no name could say in short.
std::string unit_in_name(const std::string& unit);

/// What a person reads beside its value: "Angle under water". Without a label of its own it is the name,
/// without section and unit.
std::string label_of(const Parameter& parameter);
/// The same of one of its choices, or of any name: "largest_depth" is "Largest depth".
std::string label_of_choice(const Parameter& parameter, const std::string& choice);
std::string label_of_name(std::string name);
/// A value as a person reads it, with its unit: "35 °", "off", "Largest depth".
std::string value_text(const Parameter& parameter, const Value& value);

/// The value as presets, journals and --set write it; numbers keep every bit.
std::string to_text(const Value& value);

/// The declared parameters with their present values. Values outside of a declared range never get in.
class Parameters {
  public:
    explicit Parameters(std::vector<Parameter> declared);

    const std::vector<Parameter>& declared() const { return *declared_; }
    const Parameter& declaration(std::string_view name) const;
    const Value& value(std::string_view name) const;
    /// True once a preset, a person or a file gave the value; false while it is the default.
    bool is_given(std::string_view name) const;

    double number(std::string_view name) const { return std::get<double>(value(name)); }
    int whole(std::string_view name) const { return std::get<int>(value(name)); }
    bool toggle(std::string_view name) const { return std::get<bool>(value(name)); }
    const std::string& choice(std::string_view name) const { return std::get<std::string>(value(name)); }
    /// Which of its choices it is, as an enum whose values stand in their order.
    template <typename Enum>
    Enum choice_as(std::string_view name) const {
        return static_cast<Enum>(place_of_choice(name));
    }

    // A parameter's old name is taken wherever its name is.
    /// Throws talus::Error for an unknown name, a wrong type or a value out of range, and changes nothing
    /// then.
    void set(std::string_view name, const Value& value);
    /// The same from text, as in --set thermal.repose_deg=30.
    void set_text(std::string_view name, const std::string& text);
    /// From "name=value".
    void set_assignment(const std::string& assignment);
    /// Sets a default that depends on the terrain: only where nobody gave a value, and still counted as not
    /// given.
    void suggest(std::string_view name, const Value& value);

    /// Back to the default, or to what it follows, as if nobody had given a value. Throws talus::Error for an
    /// unknown name.
    void reset(std::string_view name);

    bool operator==(const Parameters& other) const { return values_ == other.values_; }

  private:
    void pass_on(const Parameter& followed);
    int place_of_choice(std::string_view name) const;
    Value checked(const Parameter& parameter, const Value& value) const;

    std::shared_ptr<const std::vector<Parameter>> declared_;  // the same for all copies
    std::map<std::string, Value, std::less<>> values_;
    std::map<std::string, bool, std::less<>> given_;
};

}  // namespace talus
