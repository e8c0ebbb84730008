#pragma once

#include <cstddef>
#include <functional>

namespace pendular {

/// Calls `work` with each index from 0 to `count` - 1, in several threads at once: one thread for
/// every three indices, at most `threads`. Exceptions that `work` throws are passed on.
/// @param threads largest number of threads, the calling one included
/// @param before_each called by the calling thread, before each index that it processes itself; may
///        be empty, and may throw to end the work
void side_by_side(std::size_t count, std::size_t threads,
                  const std::function<void(std::size_t)>& before_each,
                  const std::function<void(std::size_t)>& work);

}  // namespace pendular
