#pragma once
#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "sim/simulation.h"
#include "sim/terrain/state_hash.h"

namespace talus {

/// Does acts, each an entry of undo: act(number). Then undo leads back to every state between them and redo
/// forth to the last, to the bit; and it goes on as if nothing had been undone. `expect_same` compares two
/// readings of the ledger.
template <typename Act, typename ExpectSame>
void expect_undo_leads_back_and_forth(Simulation& simulation, int acts, Act&& act, ExpectSame&& expect_same) {
    const auto hash_of = [](const Simulation& of) { return state_hash(of.read()); };
    std::vector<std::uint64_t> hashes = {hash_of(simulation)};
    std::vector<LedgerReading> ledgers = {simulation.ledger()};
    for (int number = 0; number < acts; ++number) {
        act(number);
        hashes.push_back(hash_of(simulation));
        ledgers.push_back(simulation.ledger());
    }
    for (std::size_t back = hashes.size() - 1; back-- > 0;) {
        ASSERT_TRUE(simulation.can_undo());
        simulation.undo();
        EXPECT_EQ(hash_of(simulation), hashes[back]) << back;
        expect_same(simulation.ledger(), ledgers[back]);
    }
    while (simulation.can_redo()) simulation.redo();
    EXPECT_EQ(hash_of(simulation), hashes.back());
    expect_same(simulation.ledger(), ledgers.back());
    Simulation other(simulation.read(), simulation.parameters());
    simulation.apply(Ticks{5});
    other.apply(Ticks{5});
    EXPECT_EQ(hash_of(simulation), hash_of(other));
}

}  // namespace talus
