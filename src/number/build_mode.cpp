// SPDX-License-Identifier: LGPL-3.0-or-later
#include <corral/build_mode.h>

namespace corral::detail {

#ifdef _GLIBCXX_DEBUG
const char library_is_compiled_with_GLIBCXX_DEBUG = 1;
#else
const char library_is_compiled_without_GLIBCXX_DEBUG = 1;
#endif

} // namespace corral::detail
