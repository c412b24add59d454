// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERTEX_FORMULAS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERTEX_FORMULAS_H

// Every formula of the backends, once. These headers are valid C++ and valid OpenCL C 1.2: the host backends include
// them, a device backend compiles them (the list is in CMakeLists.txt).
//
// A verb `v` of a backend is a loop over `v_at(i, ...)`, which does for element i all that the verb does. Its arguments
// have the order of the verb's. Verbs that return sums have a last argument `s`, to whose elements element i adds its
// share. A backend adds the loop and the order of the sums, nothing else.
#include <CGAL/Spherical_parameterization/internal/backend/formulas/linear_algebra.h>
#include <CGAL/Spherical_parameterization/internal/backend/formulas/float_cycle.h>
#include <CGAL/Spherical_parameterization/internal/backend/formulas/power.h>
#include <CGAL/Spherical_parameterization/internal/backend/formulas/saddle_point.h>
#include <CGAL/Spherical_parameterization/internal/backend/formulas/spring_energy.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_VERTEX_FORMULAS_H
