// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CORRAL_CHECKER_UNPACK_H
#define CORRAL_CHECKER_UNPACK_H

#include <string>

namespace corral_check {

/// The JSON text in the bytes of a file, which may be gzip. \throw Rejected if it is damaged; Stopped if it is too
/// long.
[[nodiscard]] std::string unpack(std::string bytes);

} // namespace corral_check

#endif
