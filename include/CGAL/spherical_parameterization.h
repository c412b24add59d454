// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_H

// The whole package in one header.

#include <CGAL/Spherical_parameterization/values/Result.h>
#include <CGAL/Spherical_parameterization/align_maps.h>
#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/for_each_index.h>
#include <CGAL/Spherical_parameterization/harmonic_alignment.h>
#include <CGAL/Spherical_parameterization/harmonic_files.h>
#include <CGAL/Spherical_parameterization/harmonic_grids.h>
#include <CGAL/Spherical_parameterization/laplacian_eigenpairs.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/values/methods.h>
#include <CGAL/Spherical_parameterization/moebius_centring.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/register_maps.h>
#include <CGAL/Spherical_parameterization/resample.h>
#include <CGAL/Spherical_parameterization/resampling_weights.h>
#include <CGAL/Spherical_parameterization/rigid_path.h>
#include <CGAL/Spherical_parameterization/segmentation.h>
#include <CGAL/Spherical_parameterization/shape_atlas.h>
#include <CGAL/Spherical_parameterization/shape_form.h>
#include <CGAL/Spherical_parameterization/shape_signature.h>
#include <CGAL/Spherical_parameterization/shape_statistics.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/stretch_histogram.h>
#include <CGAL/Spherical_parameterization/texture_coordinates.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>
#include <CGAL/Spherical_parameterization/version.h>

#endif // CGAL_SPHERICAL_PARAMETERIZATION_H
