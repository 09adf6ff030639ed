#include <fmt/format.h>
#include <imgui.h>

#include "app/panels/panels.h"

namespace talus {
namespace {

void line(const char* name, double value, const char* unit) {
    ImGui::TextUnformatted(name);
    ImGui::SameLine(150);
    ImGui::TextUnformatted(fmt::format("{:.6g} {}", value, unit).c_str());
}

}  // namespace

void draw_ledger_panel(const Session& session, PanelRequests& requests) {
    if (ImGui::Button("Balance now")) requests.acts.emplace_back([](Session& s) { s.balance(); });
    if (!session.last_balance()) return;
    const auto& [ledger, simulated_s] = *session.last_balance();
    ImGui::SameLine();
    ImGui::Text("at %.2f s", simulated_s);
    line("Bedrock", ledger.bedrock, "m³");
    line("Regolith, solid", ledger.regolith, "m³");
    line("Suspended", ledger.suspended, "m³");
    line("  brought", ledger.solid_in, "m³");
    line("  taken", ledger.solid_out, "m³");
    line("  moved", ledger.moved_m3(), "m³");
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

}  // namespace talus
