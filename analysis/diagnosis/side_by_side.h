#pragma once

#include <cstddef>
#include <functional>

namespace pendular {

/// Calls `work` once with each index below `count`, in several threads at once: `count`/2, but at
/// least 1 and at most `threads`, including the calling one. Exceptions are passed on.
/// @param before_each called by the calling thread with each index that it processes itself; may be
///        empty, and may throw to end the work
void side_by_side(std::size_t count, std::size_t threads,
                  const std::function<void(std::size_t)>& before_each,
                  const std::function<void(std::size_t)>& work);

}  // namespace pendular
