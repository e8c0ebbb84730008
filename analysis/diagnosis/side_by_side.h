#pragma once

#include <cstddef>
#include <functional>

namespace pendular {

/// Calls `work` with each index from 0 to count - 1, in several threads if `count` is large enough.
/// `before_each` is called by the calling thread alone, before each index that it takes on, and may
/// throw to end the work.
/// @param threads largest number of threads, including the calling one
void side_by_side(std::size_t count, std::size_t threads,
                  const std::function<void(std::size_t)>& before_each,
                  const std::function<void(std::size_t)>& work);

}  // namespace pendular
