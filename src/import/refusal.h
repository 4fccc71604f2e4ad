#pragma once

#include "core/error.h"

namespace ink::import {

/// What a file asks for is known, or said to be needed, and not read here: the file is not damaged.
class Refusal : public core::Error {
  public:
    using core::Error::Error;
};

}  // namespace ink::import
