#include "runner/step.h"

namespace tool {

Step count_step()
{
  return {"count",
          "Count the vertices of meshes",
          {Takes::EACH},                                          // IN, folders, --list, --jobs
          {{"-o,--output", "Text file of the number", {".txt"}}}, // and --report
          [] {
            const auto counts_faces = std::make_shared<bool>(false);
            Work work = {[counts_faces](Run& run) {
              run.read(); // or it is refused
              const Mesh& mesh = run.mesh();
              const std::size_t number = *counts_faces ? mesh.number_of_faces() : mesh.number_of_vertices();
              if(std::ostream* out = run.out())
                *out << number << '\n';
              run.details["number"] = number; // in the report
              run.line = std::to_string(number) + (*counts_faces ? " faces" : " vertices");
              run.text = run.name_of_input() + ": " + run.line;
            }};
            work.options("--faces", *counts_faces, "Count the faces");
            return work;
          },
          "count bunny.ply -o count.txt"};
}

} // namespace tool
