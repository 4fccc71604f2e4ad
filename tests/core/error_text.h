#pragma once

#include <string>

#include "core/error.h"

namespace ink::core {

/// What the Error of `call` says; "" if it throws none.
template <class Call>
std::string error_text(const Call& call) {
    try {
        static_cast<void>(call());
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace ink::core
