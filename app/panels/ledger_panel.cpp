#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"

namespace talus::app {
namespace {

void line(const char* name, double value, const char* unit) {
    figure_line(name, fmt::format("{} {}", figure(value, 6), unit));
}

template <typename Value>
void plot(const std::vector<Balance>& balances, const char* name, const char* unit, Value value) {
    std::vector<float> values;
    values.reserve(balances.size());
    for (const Balance& balance : balances) values.push_back(static_cast<float>(value(balance.ledger)));
    plot_line(name, values, unit);
}

}  // namespace

void draw_ledger_panel(PanelContext& context) {
    Session& session = context.session;
    session.follow_ledger();
    if (button("Balance now", "reads the ledger as it stands"))
        context.requests.acts.emplace_back([](Session& s) { s.balance(); });
    const std::vector<Balance>& balances = session.balances();
    if (balances.empty()) return;
    const auto& [ledger, simulated_s] = balances.back();
    ImGui::SameLine();
    ImGui::Text("at %.2f s", simulated_s);
    const LedgerReading& first = balances.front().ledger;
    plot(balances, "bedrock", "m³", [&](const LedgerReading& l) { return l.bedrock - first.bedrock; });
    plot(balances, "regolith", "m³", [](const LedgerReading& l) { return l.regolith; });
    plot(balances, "suspended", "m³", [](const LedgerReading& l) { return l.suspended; });
    plot(balances, "out by edges", "m³", [](const LedgerReading& l) { return l.solid_edges_out; });
    plot(balances, "missing", "m³", [](const LedgerReading& l) { return l.closing_error_m3(); });
    line("Bedrock", ledger.bedrock, "m³");
    line("Regolith, solid", ledger.regolith, "m³");
    line("Suspended", ledger.suspended, "m³");
    line("  brought", ledger.solid_in, "m³");
    line("  taken", ledger.solid_out, "m³");
    line("  out by edges", ledger.solid_edges_out, "m³");
    line("  eroded, net", ledger.eroded_m3, "m³");
    line("  deposited, net", ledger.deposited_m3, "m³");
    line("  missing", ledger.closing_error_m3(), "m³");
    line("Water on the map", ledger.water_final, "m³");
    line("  at the start", ledger.water_initial, "m³");
    line("  came in", ledger.water_in, "m³");
    line("  went out", ledger.water_out, "m³");
    line("  missing", ledger.water_drift_relative() * 1e6, "millionths of all");
}

}  // namespace talus::app
