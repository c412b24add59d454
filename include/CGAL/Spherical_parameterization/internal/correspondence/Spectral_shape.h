// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_SHAPE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_SHAPE_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Geodesic_graph.h>
#include <CGAL/Spherical_parameterization/internal/locate/Locator.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/kernel_signatures.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/laplacian_spectrum.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/conformal_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/even_samples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A map to the sphere as a table: of every direction, a vertex near it.
template <class Loop>
class Vertex_table {
public:
  /// \param map  a valid one
  Vertex_table(const Loop& loop, const Mapped_surface& map) : vertex_(6 * cells_of_edge * cells_of_edge)
  {
    const Locator locator(loop, Valid_map(map, loop));
    loop.for_each(6 * cells_of_edge, [&](int row) {
      const int side = row / cells_of_edge, i = row % cells_of_edge;
      for(int j = 0; j < cells_of_edge; ++j) {
        const double u = (2 * i + 1.) / cells_of_edge - 1, v = (2 * j + 1.) / cells_of_edge - 1, s = side % 2 ? 1 : -1;
        const vec3 q = side < 2 ? make_vec3(s, u, v) : side < 4 ? make_vec3(u, s, v) : make_vec3(u, v, s);
        const auto [face, weight] = locator.locate(q);
        vertex_[cell(q)] = map.face[face][std::max_element(weight.begin(), weight.end()) - weight.begin()];
      }
    });
  }

  int operator()(vec3 q) const { return vertex_[cell(q)]; }

private:
  static constexpr int cells_of_edge = 64; ///< of a cube round the sphere

  static int cell(vec3 q)
  {
    const double x = std::abs(q.x), y = std::abs(q.y), z = std::abs(q.z), most = (std::max)({x, y, z});
    const auto place = [&](double u) {
      return (std::min)(cells_of_edge - 1, static_cast<int>((u / most + 1) / 2 * cells_of_edge));
    };
    const auto number = [&](int side, double u, double v) {
      return (side * cells_of_edge + place(u)) * cells_of_edge + place(v);
    };
    if(x == most)
      return number(q.x > 0, q.y, q.z);
    if(y == most)
      return number(2 + (q.y > 0), q.x, q.z);
    return number(4 + (q.z > 0), q.x, q.y);
  }

  std::vector<int> vertex_;
};

/// What the correspondence of two shapes is found by: eigenfunctions, signatures and samples of a surface, and where it
/// lies on the sphere. `Loop` makes the matrices of Eigen dependent, as `Dense` does.
template <class Loop>
struct Spectral_shape {
  /// A row for each vertex. Floats are enough to choose by.
  typedef typename Floats<Loop>::Rows Rows;

  static constexpr int most_functions = 120, number_of_energies = 40, number_of_bands = 8, number_of_features = 9;

  Rows function;                  ///< the eigenfunctions of the surface of area 1
  Rows signature;                 ///< the wave kernel signature
  Rows feature;                   ///< curvature, and logarithms of the signature in bands of energies
  std::vector<double> area;       ///< of every vertex, 1 in all
  std::vector<double> remoteness; ///< of every vertex: the mean geodesic distance to all others, from 0 to 1
  std::vector<double> stretch;    ///< of every vertex: the logarithm of its area by that on the sphere
  /// Of every vertex: the mean curvature of variance 1, smooth at two scales.
  std::array<std::vector<double>, 2> curvature;
  Host_array<vec3> image;         ///< on the sphere
  Vertex_table<Loop> vertex_near; ///< by direction
  std::vector<int> sample;        ///< vertices far from each other, those first that are farthest
  std::vector<int> tip; ///< vertices more remote than all near them: ends of limbs, remotest first; never none
  std::vector<std::vector<double>> tip_distance; ///< of the tips from each other, geodesic
  std::vector<int> target;                       ///< the samples, and others: what another shape is mapped to
  Rows corner; ///< eigenfunctions at the corners of some faces, three rows a face; each face stands for as much area
  Rows sphere; ///< by eigenfunction: the coefficients of the image
  Geodesic_graph graph;

  /// The parts of the surface that are nearest to each of the first samples.
  struct Cells {
    std::vector<double> area;
    std::vector<int> of_vertex;
    int size() const { return static_cast<int>(area.size()); }
  };
  Cells few, some, all; ///< of 250, 400, 800 samples

  int size() const { return static_cast<int>(image.size()); }
  int number_of_functions() const { return static_cast<int>(function.cols()); }

  /// \param map  a valid one; of a surface of area 1
  Spectral_shape(const Loop& loop, const Mapped_surface& map, Monitor& monitor)
    : Spectral_shape(loop, map, map.copy_of_corner_table(loop), monitor)
  {}

private:
  Spectral_shape(const Loop& loop, const Mapped_surface& map, const Corner_table& table, Monitor& monitor)
    : area(map.vertex_area(loop).begin(), map.vertex_area(loop).end()), stretch(map.number_of_vertices),
      image(map.image), vertex_near(loop, map), graph(table, map.point)
  {
    const int n = size();
    const Host_array<double> on_sphere = vertex_areas(loop, map.face, image);
    constexpr double least = 1e-12;
    for(int i = 0; i < n; ++i)
      stretch[i] = std::log((std::max)(area[i], least) / (std::max)(on_sphere[i] / (4 * pi), least));
    Spring_lengths lengths;
    const Weighted_graph laplacian = conformal_graph(loop, table, map.point, lengths);
    Host_array<double> mass(area.begin(), area.end());
    for(double& m : mass)
      m = (std::max)(m, least / n); // of needles
    const Laplacian_eigenpairs spectrum =
      laplacian_spectrum(loop, laplacian, mass, (std::min)(most_functions, n / 2), monitor);
    function.resize(n, static_cast<int>(spectrum.number()));
    for(int k = 0; k < static_cast<int>(spectrum.number()); ++k)
      for(int i = 0; i < n; ++i)
        function(i, k) = static_cast<float>(spectrum.function(k, i));
    sphere = Rows::Zero(function.cols(), 3);
    for(int i = 0; i < n; ++i)
      for(int c = 0; c < 3; ++c)
        sphere.col(c) += static_cast<float>(area[i] * std::array<double, 3>{image[i].x, image[i].y, image[i].z}[c]) *
                         function.row(i).transpose();
    monitor.advance_or_throw();
    find_signatures(spectrum.value);
    find_curvatures(table, map.point, spectrum.value);
    choose_features();
    choose_faces(loop, map);
    choose_samples(loop, map.point);
  }

  void find_signatures(const std::vector<double>& value)
  {
    constexpr std::size_t most = 100;
    const int last = static_cast<int>((std::min)(most, value.size()));
    const auto filters = wave_kernel_filters({value.begin(), value.begin() + last}, number_of_energies);
    Rows filter(last, number_of_energies);
    for(int e = 0; e < number_of_energies; ++e)
      for(int k = 0; k < last; ++k)
        filter(k, e) = static_cast<float>(filters[e][k]);
    const Rows square = function.leftCols(last).array().square();
    signature = square * filter;
  }

  /// Mean curvature by the angles at the edges, low frequencies only.
  void find_curvatures(const Corner_table& table, const Host_array<vec3>& point, const std::vector<double>& value)
  {
    constexpr double scale[] = {0.03, 0.06}; // of the heat flow that it is seen through, as a length
    constexpr int most = 120;
    const int n = size(), number = (std::min)(most, number_of_functions());
    std::vector<double> bending(n, 0.);
    for(int h = 0; h < table.number_of_halfedges(); ++h) {
      const int t = table.twin[h];
      if(t < h)
        continue;
      const vec3 e = sub(point[table.target(h)], point[table.origin(h)]), u = normal(point, table.face[h / 3]),
                 v = normal(point, table.face[t / 3]);
      const double angle = std::atan2(inner(outer(u, v), e), norm(e) * inner(u, v));
      bending[table.origin(h)] += norm(e) * angle / 4;
      bending[table.target(h)] += norm(e) * angle / 4;
    }
    std::vector<double> sharp(number, 0.);
    for(int k = 1; k < number; ++k) // the constant is no feature
      for(int i = 0; i < n; ++i)
        sharp[k] += bending[i] * function(i, k);
    for(std::size_t s = 0; s < curvature.size(); ++s) {
      std::vector<double> coefficient = sharp;
      double square = 0;
      for(int k = 1; k < number; ++k) {
        coefficient[k] *= std::exp(-value[k] * scale[s] * scale[s] / 2);
        square += coefficient[k] * coefficient[k];
      }
      curvature[s].assign(n, 0.);
      for(int i = 0; i < n; ++i)
        for(int k = 1; k < number; ++k)
          curvature[s][i] += coefficient[k] / std::sqrt((std::max)(square, 1e-300)) * function(i, k);
    }
  }

  void choose_features()
  {
    constexpr int width = number_of_energies / number_of_bands;
    constexpr float least = 1e-30F;
    feature.resize(size(), number_of_features);
    for(int i = 0; i < size(); ++i) {
      feature(i, 0) = static_cast<float>(curvature[0][i]);
      for(int band = 0; band < number_of_bands; ++band) {
        const float sum = signature.row(i).segment(band * width, width).sum();
        feature(i, 1 + band) = std::log((std::max)(sum, least)) / std::sqrt(static_cast<float>(number_of_bands));
      }
    }
  }

  /// \param distance  from the first samples
  void choose_tips(const std::vector<std::vector<double>>& distance)
  {
    constexpr double near = 0.25;
    constexpr std::size_t most = 7;
    std::vector<std::size_t> found;
    for(std::size_t k = 0; k < distance.size(); ++k)
      if(std::none_of(sample.begin(), sample.begin() + distance.size(), [&](int other) {
           return distance[k][other] < near && remoteness[other] > remoteness[sample[k]];
         }))
        found.push_back(k);
    std::stable_sort(found.begin(), found.end(),
                     [&](std::size_t k, std::size_t l) { return remoteness[sample[k]] > remoteness[sample[l]]; });
    found.resize((std::min)(found.size(), most));
    for(std::size_t k : found) {
      tip.push_back(sample[k]);
      std::vector<double> row;
      for(std::size_t l : found)
        row.push_back(distance[k][sample[l]]);
      tip_distance.push_back(std::move(row));
    }
  }

  void choose_faces(const Loop& loop, const Mapped_surface& map)
  {
    constexpr int number = 1000;
    const Host_array<double>& face_area = map.face_area(loop);
    corner.resize(3 * number, function.cols());
    int r = 0;
    for(int f : faces_at_even_areas(face_area, std::accumulate(face_area.begin(), face_area.end(), 0.), number))
      for(int v : map.face[f])
        corner.row(r++) = function.row(v);
  }

  void choose_samples(const Loop& loop, const Host_array<vec3>& point)
  {
    constexpr int most_far = 150, most_few = 250, most_some = 400, most_all = 800, most_others = 1700;
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const int n = size(), far = (std::min)(most_far, n), number = (std::min)(most_all, n);
    const auto farthest = [](const std::vector<double>& d) {
      return static_cast<int>(std::max_element(d.begin(), d.end()) - d.begin());
    };
    // The first ones by geodesic distances, which also say how remote vertices are
    std::vector<double> near(n, infinity);
    std::vector<int> cell(n, 0);
    std::vector<std::vector<double>> distance;
    int next = farthest(graph.distances(0));
    for(int k = 0; k < far; ++k) {
      sample.push_back(next);
      distance.push_back(graph.distances(next));
      for(int i = 0; i < n; ++i)
        if(distance[k][i] < near[i]) {
          near[i] = distance[k][i];
          cell[i] = k;
        }
      next = farthest(near);
    }
    std::vector<double> of_cell(far, 0.);
    for(int i = 0; i < n; ++i)
      of_cell[cell[i]] += area[i];
    remoteness.assign(n, 0.);
    for_each_index(loop, n, [&](int i) {
      for(int k = 0; k < far; ++k)
        remoteness[i] += of_cell[k] * distance[k][i];
    });
    const auto [low, high] = std::minmax_element(remoteness.begin(), remoteness.end());
    const double least = *low, width = (std::max)(*high - *low, 1e-300);
    for(double& r : remoteness)
      r = (r - least) / width;

    choose_tips(distance);

    // The others by distances in space
    const auto cells = [&](int m) {
      Cells result = {std::vector<double>(m, 0.), cell};
      for(int i = 0; i < n; ++i)
        result.area[cell[i]] += area[i];
      return result;
    };
    std::fill(near.begin(), near.end(), infinity);
    for(int k = 0; k < number; ++k) {
      if(k >= far)
        sample.push_back(farthest(near));
      const vec3 p = point[sample[k]];
      for(int i = 0; i < n; ++i)
        if(const double square = squared_distance(point[i], p); square < near[i]) {
          near[i] = square;
          cell[i] = k;
        }
      if(k + 1 == (std::min)(most_few, number))
        few = cells(k + 1);
      if(k + 1 == (std::min)(most_some, number))
        some = cells(k + 1);
    }
    all = cells(number);

    target = sample;
    std::vector<char> is_target(n, 0);
    for(int i : sample)
      is_target[i] = 1;
    const int others = (std::min)(most_others, n);
    for(int k = 0; k < others; ++k) {
      const auto i = static_cast<int>(static_cast<long long>(k) * n / others);
      if(!is_target[i])
        target.push_back(i);
    }
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_SHAPE_H
