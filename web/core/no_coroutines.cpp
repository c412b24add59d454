// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// oneTBB can suspend a task and switch to another stack. WebAssembly cannot, and nothing here suspends one: oneTBB
// notes the contexts of its threads, and never goes back to one.

#include <cstdlib>
#include <ucontext.h>

extern "C" {

int getcontext(ucontext_t*) { return 0; }
void makecontext(ucontext_t*, void (*)(), int, ...) { std::abort(); }
int swapcontext(ucontext_t*, const ucontext_t*) { std::abort(); }
}
