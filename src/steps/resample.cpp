// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "runner/step.h"

#include "preparation/prepare.h"

#include <CGAL/Spherical_parameterization/resample.h>

#include <array>
#include <memory>
#include <sstream>

namespace tool {
namespace {

/// What may be lost without a word, of the diagonal and of a side of the bounding box.
constexpr double largest_distance = 0.01, largest_loss_of_box = 0.03;

/// The point of the shape that is mapped to the direction.
Point point_at(const SP::Spherical_locator<Mesh>& shape, const Point& direction)
{
  const auto place = shape.locate(direction);
  Point point;
  for(std::size_t k = 0; k < 3; ++k)
    point[k] = SP::interpolate(shape.mesh(), place,
                               boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) {
                                 return shape.mesh().points()[static_cast<std::size_t>(v.idx())][k];
                               }));
  return point;
}

void resample(int level, Run& run)
{
  run.read();
  run.map();
  std::vector<Point> directions;
  std::vector<std::array<int, 3>> triangles;
  SP::make_icosphere_soup(level, directions, triangles);
  const Mesh out(directions, triangles);
  const SP::Spherical_locator<Mesh> shape(run.mesh(), as_map(run.input.sphere));
  std::vector<Point> points;
  for(const Point& direction : out.points())
    points.push_back(point_at(shape, direction));
  run.write("--output", out, points, Surface::SHAPE);
  run.write("--output-sphere", out, out.points(), Surface::SPHERE);
  const Sampling_loss loss = sampling_loss(run.mesh(), out, points);
  run.details["resample"] = {{"level", level},
                             {"vertices", out.number_of_vertices()},
                             {"distance", loss.distance},
                             {"bounding_box", loss.bounding_box}};
  run.commit();
  const std::string& method = run.input.result.method;
  std::ostringstream line;
  line.precision(2);
  line << out.number_of_vertices() << " vertices, " << out.number_of_faces() << " faces; " << method
       << (method.empty() ? "" : " map; ") << "99 % of the shape is within " << 100 * loss.distance
       << " % of its diagonal, the bounding box has lost " << 100 * loss.bounding_box << " %";
  if(loss.distance > largest_distance || loss.bounding_box > largest_loss_of_box)
    line << "; part of the shape is lost, where the map is small: try --method isometric, --area-exponent 30 or a "
            "larger --level";
  run.line = line.str();
  run.text = preparation_text(run.name_of_input(), run.input.prepared) + run.name_of_output() + ": " + run.line;
}

Work resample_work()
{
  const auto level = std::make_shared<int>(6);
  Work work = {[level](Run& run) { resample(*level, run); }};
  work.options.add("--level", *level, "The new mesh has 10 * 4^LEVEL + 2 vertices")
    .in("[0," + std::to_string(SP::largest_icosphere_level) + ']');
  return work;
}

} // namespace

Step resample_step()
{
  Takes takes = {Takes::EACH, "isometric", "conformal", Takes::OPTION, Prepare::ALL}; // which loses no limb
  takes.prepared = "the shape that is sampled is that of the mended mesh";
  return {"resample",
          "Sample a shape at the vertices of an icosphere",
          takes,
          {{"-o,--output", "Output file of the new mesh", {}, Output::MESH, Output::REQUIRED},
           {"--output-sphere", "Write the icosphere as well: it is the map of the new mesh", {}, Output::MESH}},
          resample_work,
          "resample bunny.ply -o icosphere.off --level 7"};
}

} // namespace tool
