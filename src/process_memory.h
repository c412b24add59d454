// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

namespace tool {

/// To be called at the start. Large arrays then go back to the system as soon as they are freed, and of what small ones
/// take 64 MB stay: to map them anew took a fifth of the time of a folder of small meshes. And the stack has room.
///
/// `new` is replaced in this program, so that all its large arrays have large pages, as those of the library have.
void manage_memory();

} // namespace tool
