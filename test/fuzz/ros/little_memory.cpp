// SPDX-License-Identifier: BSD-3-Clause
// A machine with little memory: roscpp takes as much as the length in a message says, before it looks whether so much
// came.
#include <cstdlib>
#include <new>

namespace {
constexpr std::size_t kMost = std::size_t{256} << 20U;  // [byte], at once
}

void* operator new(std::size_t size) {
  void* const memory = size <= kMost ? std::malloc(size > 0 ? size : 1) : nullptr;
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  return std::malloc(size > 0 ? size : 1);
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
