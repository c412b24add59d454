// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ANY_POLICY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ANY_POLICY_H

#include <CGAL/tags.h>
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#endif

#include <variant>

namespace CGAL::Spherical_parameterization {
/// \addtogroup PkgSphericalParameterizationPolicies
/// @{

/// One of the execution policies of this build, for programs that choose it at run time.
using Any_policy = std::variant<CGAL::Sequential_tag
#ifdef CGAL_LINKED_WITH_TBB
                                ,
                                CGAL::Parallel_tag
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
                                ,
                                OpenCL_device
#endif
                                >;

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ANY_POLICY_H
