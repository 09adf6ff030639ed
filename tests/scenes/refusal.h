#pragma once
#include <gtest/gtest.h>

#include <string>

#include "sim/error.h"

namespace talus {

/// What an act says of a file that it refuses: one sentence that names it. A failure where it takes the file.
template <typename Act>
std::string refusal_of(const std::string& name, Act&& act) {
    try {
        act();
    } catch (const Error& error) {
        std::string message = error.what();
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_NE(message.find(name), std::string::npos) << message;
        return message;
    }
    ADD_FAILURE() << name << " was taken";
    return "";
}

}  // namespace talus
