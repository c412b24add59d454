// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_FORM_VALUES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_FORM_VALUES_H

#include <CGAL/Spherical_parameterization/internal/algebra/histogram.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/even_samples.h>
#include <CGAL/Spherical_parameterization/values/Error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Of what the numbers of a form are, in their order.
struct Form_sizes {
  static constexpr std::size_t angles = 4;     ///< bins of a cosine between 0 and 1
  static constexpr std::size_t distances = 16; ///< between two points
  static constexpr std::size_t radii = 12;     ///< from the centre
  static constexpr std::size_t pairs = distances * angles;
  static constexpr std::size_t all = pairs + radii * angles;
};
typedef std::array<float, Form_sizes::all> Form_values;

/// Shares of points in bins of two quantities, between whose centres they are interpolated.
template <std::size_t rows, std::size_t columns>
class Joint_histogram {
public:
  /// \param x  from 0 to 1; what is beyond counts as 1
  /// \param y  the same
  void add(double x, double y)
  {
    const auto [i, u] = Place_between_bins(x * rows, rows);
    const auto [j, v] = Place_between_bins(y * columns, columns);
    sum_[i][j] += (1 - u) * (1 - v);
    sum_[i][j + 1] += (1 - u) * v;
    sum_[i + 1][j] += u * (1 - v);
    sum_[i + 1][j + 1] += u * v;
    ++count_;
  }

  /// The shares, divided by `unit`. Returns the end of what was written.
  template <class Iterator>
  Iterator write(double unit, Iterator out) const
  {
    for(const auto& row : sum_)
      out = std::transform(row.begin(), row.end(), out,
                           [&](double sum) { return static_cast<float>(sum / (static_cast<double>(count_) * unit)); });
    return out;
  }

private:
  std::array<std::array<double, columns>, rows> sum_ = {};
  std::size_t count_ = 0;
};

/// A point of a surface, and the unit normal of its face.
struct Surface_sample {
  vec3 point, normal;
};

/// Points spread evenly over the area, around their centre, with a mean square distance of 1 from it. Throws Error for
/// a surface without area.
inline std::vector<Surface_sample> samples_of(const Surface& surface, int count)
{
  const Host_array<double>& area = surface.face_area(Host_loop());
  const double total = std::accumulate(area.begin(), area.end(), 0.);
  if(!(total > 0))
    throw Input_error(Error_code::DEGENERATE_FACE, "the area of the surface is 0");
  constexpr double first_step = 0.7548776662466927, second_step = 0.5698402909980532;
  const std::vector<int> faces = faces_at_even_areas(area, total, count);
  std::vector<Surface_sample> samples;
  for(int i = 0; i < count; ++i) {
    const int face = faces[i];
    const auto [a, b, c] = surface.in_source(face);
    const double s = std::sqrt(quasirandom(i, first_step)), t = quasirandom(i, second_step);
    const vec3 n = normal(surface.point, surface.face[face]);
    const double length = norm(n);
    samples.push_back(
      {add_scaled(add_scaled(scale(1 - s, a), s * (1 - t), b), s * t, c), length > 0 ? scale(1 / length, n) : n});
  }
  vec3 centre = {0, 0, 0};
  for(const Surface_sample& sample : samples)
    centre = add_scaled(centre, 1. / count, sample.point);
  double square = 0;
  for(Surface_sample& sample : samples) {
    sample.point = sub(sample.point, centre);
    square += inner(sample.point, sample.point) / count;
  }
  for(Surface_sample& sample : samples)
    sample.point = scale(1 / std::sqrt(square), sample.point);
  return samples;
}

/// What the medians of all pairs of the 380 models of the Princeton benchmark are, so that both parts weigh the same.
constexpr double pairs_unit = 0.435;
constexpr double radii_unit = 0.88;

/// The form of a surface: how far pairs of its points are from each other, and how much their normals differ; how far
/// its points are from the centre, and how much their normals point there. Throws Error for a surface without area.
inline Form_values form_values(const Surface& surface)
{
  constexpr double largest_distance = 4, largest_radius = 2.5; // the mean square radius is 1
  const std::vector<Surface_sample> samples = samples_of(surface, 1024);
  Joint_histogram<Form_sizes::distances, Form_sizes::angles> pairs;
  Joint_histogram<Form_sizes::radii, Form_sizes::angles> radii;
  for(auto a = samples.begin(); a != samples.end(); ++a) {
    const double radius = norm(a->point);
    radii.add(radius / largest_radius, std::abs(inner(a->point, a->normal)) / (std::max)(radius, 1e-12));
    for(auto b = samples.begin(); b != a; ++b)
      pairs.add(norm(sub(a->point, b->point)) / largest_distance, std::abs(inner(a->normal, b->normal)));
  }
  Form_values values;
  radii.write(radii_unit, pairs.write(pairs_unit, values.begin()));
  return values;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SIGNATURE_FORM_VALUES_H
