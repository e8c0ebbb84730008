#pragma once

#include <cstddef>
#include <functional>

namespace pendular {

/// Calls `work` once with each index from 0 to `count` - 1, in several threads at once. The number
/// of threads is `count`/2, but at least 1 and at most `threads`. Exceptions that `work` throws are
/// passed on.
/// @param threads largest number of threads, including the calling thread
/// @param before_each function that the calling thread calls with each index that it processes
///        itself, before `work`; may be empty, and may throw to end the work
void side_by_side(std::size_t count, std::size_t threads,
                  const std::function<void(std::size_t)>& before_each,
                  const std::function<void(std::size_t)>& work);

}  // namespace pendular
