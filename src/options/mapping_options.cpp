// SPDX-License-Identifier: GPL-3.0-or-later

#include "options/mapping_options.h"

#include <sstream>

namespace tool {
namespace {

/// " [balanced 2e-09, saddle-point 1e-07, isometric 0.0005]"
template <class Number>
std::string defaults(Number balanced, Number saddle_point, Number isometric)
{
  std::ostringstream text;
  text << " [balanced " << balanced << ", saddle-point " << saddle_point << ", isometric " << isometric << ']';
  return text.str();
}

} // namespace

void add_mapping_options(Options& all, Mapping_options& o, bool are_for_one)
{
  using namespace CGAL::Spherical_parameterization;
  all("--triangulate", o.triangulate, "Triangulate the polygons of IN instead of refusing them");

  all.begin_group("Weights"); // those in groups say how to map
  all("--weights", o.weights,
      "Edge weights: conformal (preserves angles, however bad the triangles are), clamped (cotangents of clamped "
      "angles, as in the paper), barycentric (all 1), mean-value (always positive)")
    .of({"conformal", "clamped", "barycentric", "mean-value"});
  all("--min-angle", o.min_angle, "Clamped: lower bound to which angles are clamped, in degrees")
    .in("(0,90)")
    .only_with("--weights", {"clamped"});
  all("--max-angle", o.max_angle, "Clamped: upper bound to which angles are clamped, in degrees")
    .in("(0,90)")
    .only_with("--weights", {"clamped"});

  all.begin_group("Method");
  all("--method", o.method,
      "automatic (balanced if its map is usable, else isometric), balanced (harmonic, fast; fails for limbs so long "
      "and thin that doubles do not resolve them), isometric (low length distortion, for every mesh; without weights), "
      "saddle-point (as in the paper; it rarely converges without fixed vertices)")
    .of({"automatic", "balanced", "isometric", "saddle-point"});
  all("--spring-exponent", o.spring_exponent,
      "Balanced, automatic: exponent of the spring energy, >= 2; larger values equalize areas")
    .in("[2,1000)")
    .only_with("--method", {"balanced", "automatic"});
  all("--area-exponent", o.area_exponent,
      "Isometric, automatic: 0 preserves angles, 1 lengths, 30 or more areas " +
        std::string(are_for_one ? "[1; with --density 10]" : "[1]"))
    .in("[0,1000)")
    .only_with("--method", {"isometric", "automatic"});
  all("--largest-shrinkage", o.largest_shrinkage,
      "Automatic: by what factor lengths may shrink, relative to the mean of the map. If they shrink more on more than "
      "a thousandth of the surface, the next method is tried")
    .in("[1,inf)")
    .only_with("--method", {"automatic"});
  all("--splitting", o.splitting, "Saddle-point: splitting of the Laplacian for the sweeps")
    .of({"jacobi", "gauss-seidel"})
    .only_with("--method", {"saddle-point"});
  all("--relaxation", o.relaxation, "Saddle-point: relaxation factor in (0,1), with gauss-seidel in (0,2)")
    .in("(0,2)")
    .only_with("--method", {"saddle-point"});
  all("--check-interval", o.check_interval, "Saddle-point: number of sweeps between two convergence tests")
    .in("[1,2147483647]")
    .only_with("--method", {"saddle-point"});
  all("--start", o.start, "Saddle-point: start map, a projection from the centroid or harmonic")
    .of({"centroid", "harmonic"})
    .only_with("--method", {"saddle-point"});
  if(are_for_one) {
    all("--fixed", o.fixed,
        "Text file of fixed vertices: three or more lines 'index x y z', indices from 0 in the order of IN, positions "
        "on the sphere. isometric and automatic keep them at any positions, balanced and saddle-point only if they fit "
        "the harmonic map");
    all("--landmark-weight", o.landmark_weight,
        "Isometric: pull the fixed vertices towards their positions with this weight, instead of keeping them exactly "
        "there")
      .in("(0,inf)")
      .only_with("--method", {"isometric"});
    all("--density", o.density,
        "Isometric, automatic: text file with a positive number for every vertex or every face; areas on the sphere "
        "are to be proportional to these numbers times the areas of IN")
      .only_with("--method", {"isometric", "automatic"});
  }

  all.begin_group("Where to run");
  all("--policy", o.policy,
      "sequential (one core), tbb (all cores), opencl (a device). The map is the same. Default for several IN at the "
      "same time: sequential")
    .of({
      "sequential",
#ifdef CGAL_LINKED_WITH_TBB
      "tbb",
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
      "opencl",
#endif
    });
  all("--device", o.device,
      "OpenCL: number of the device in the list of the command 'devices', or part of its name "
      "[$CGAL_SPHERICAL_PARAMETERIZATION_DEVICE, else the first GPU]")
    .is("NUMBER|NAME")
    .only_with("--policy", {"opencl"});
  all("--precision", o.precision, "OpenCL: floating-point precision [double if the device supports it]")
    .of({"double", "single"})
    .only_with("--policy", {"opencl"});

  all.begin_group("Effort");
  all("--accuracy", o.accuracy,
      "Residual to reach; isometric: relative energy decrease at which to stop; automatic: of the balanced map" +
        defaults(Balanced::default_accuracy, Saddle_point::default_accuracy, Isometric::default_accuracy))
    .in("(0,1)");
  all("--iterations", o.iterations,
      "Maximum number of iterations; automatic: of the balanced map; isometric: fewer above 100,000 vertices" +
        defaults(Balanced::default_number_of_iterations, Saddle_point::default_number_of_iterations,
                 Isometric::default_number_of_iterations))
    .in("[1,inf)");
  all("--max-time", o.max_time, "Time limit in seconds [no limit]").in("(0,inf)");
  all.begin_group(general_options);
}

void check_mapping_options(const Mapping_options& options)
{
  require(options.weights != "clamped" || options.min_angle <= options.max_angle, "--max-angle",
          "the angles must satisfy 0 < --min-angle <= --max-angle < 90");
  require(options.splitting == "gauss-seidel" || options.relaxation < 1, "--relaxation",
          "must be in (0,1) with the Jacobi splitting and in (0,2) with the Gauss-Seidel splitting");
  require(!options.landmark_weight || !options.fixed.empty(), "--landmark-weight", "requires --fixed");
}

std::vector<File_option> input_files(const Mapping_options& options)
{
  std::vector<File_option> files = {
    {"IN", options.input}, {"--sphere", options.sphere}, {"--fixed", options.fixed}, {"--density", options.density}};
  for(const std::string& file : options.data)
    files.emplace_back("--data", file);
  return files;
}

} // namespace tool
