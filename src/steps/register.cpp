// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "output/text_writer.h"
#include "runner/pair.h"

#include <cstddef>
#include <sstream>

namespace tool {
namespace {

void write_correspondence(std::ostream& out, const std::vector<Place>& places)
{
  Text_writer write(out);
  write("vertex,face,w0,w1,w2\n");
  for(std::size_t v = 0; v < places.size(); ++v) {
    const auto& [face, weights] = places[v];
    write(v, ',', face, ',', weights[0], ',', weights[1], ',', weights[2], '\n');
  }
}

void register_meshes(const Registration_options& options, Run& run)
{
  Registered_pair pair;
  read_pair(options, pair);
  register_pair(options, pair);

  run.data = pair.a.file->data;
  run.annotations = in_space_of(pair.b.file->annotations, pair.a.file->annotations);
  run.write("--output", pair.a.mesh(), pair.points_on_b, Surface::SHAPE);
  run.annotations = pair.a.file->annotations;
  if(run.has("--output-sphere")) {
    certify_as_stored(run.file("--output-sphere"), run.mesh_format("--output-sphere").format, pair.a, pair.registered);
    run.write("--output-sphere", pair.a.mesh(), pair.registered, Surface::SPHERE);
  }
  if(run.has("--correspondence"))
    write_correspondence(*run.out("--correspondence"), places_by_files(pair));
  run.details = registration_json(options, pair);
  run.commit();

  std::ostringstream text;
  text.precision(3);
  text << preparation_text(options, pair) << run.file(run.has("--output") ? "--output" : "--correspondence") << ": "
       << options.input << " in the shape of " << options.other << ", " << pair.a.mesh().number_of_vertices()
       << " vertices\n"
       << registration_text(options, pair) << '\n'
       << pair.result.seconds.total << " s, and " << pair.a.result.seconds.total + pair.b.result.seconds.total
       << " s for the maps";
  run.text = text.str();
}

Work register_work()
{
  Work work = work_on_pair(register_meshes);
  work.check = [check = work.check](const Request& request) {
    check(request);
    require(request.has("--output") || request.has("--correspondence"), "--output", "is required, or --correspondence");
  };
  return work;
}

} // namespace

Step register_step()
{
  return {
    "register",
    "Find the points of B that correspond to the vertices of A",
    pair_of_meshes(),
    {{"-o,--output", "Output file: the mesh A, its vertices at the corresponding points of B", {}, Output::MESH},
     {"--output-sphere",
      "Write the registered sphere of A: corresponding points of A and B have the same position on their spheres",
      {},
      Output::MESH},
     {"--correspondence",
      "Write the point of B for every vertex of A: a .csv file of lines 'vertex,face,w0,w1,w2', a face of B and the "
      "weights of its corners; --output may then be left out",
      {".csv"}}},
    register_work,
    "register lion1.obj lion2.obj -o lion1_as_2.ply"};
}

} // namespace tool
