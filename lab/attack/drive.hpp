// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <iosfwd>

#include "result.hpp"
#include "spec.hpp"

namespace hidwa_attack {

/// Drives one drive; the same spec and seed give the same result. A drive ends a second after the first touch. With
/// `trace` a CSV line every 10 ms.
DriveResult drive(const Spec& spec, std::uint64_t seed, std::ostream* trace = nullptr);

}  // namespace hidwa_attack
