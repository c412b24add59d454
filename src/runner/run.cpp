// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "output/write_vertex_data.h"
#include "system/interruption.h"
#include "system/terminal.h"

namespace tool {

const std::string& Request::file(const std::string& option) const
{
  static const std::string none;
  const auto found = outputs.find(option);
  return found != outputs.end() ? found->second : none;
}

Output_format Request::mesh_format(const std::string& option) const
{
  const std::string& name = file(option);
  if(option == "--output" && !format.empty())
    for(const auto& [word, of_word] : output_formats())
      if(word == format)
        return {of_word, ascii, shown(name, "standard output")};
  require(name != standard_stream || option != "--output", "--format", "is required for the standard output");
  const auto of_name = format_of_name(name);
  require(of_name && is_written(*of_name), option, "'" + name + "' must be called " + mesh_names);
  return {*of_name, ascii, name};
}

std::string Request::settings(const std::set<std::string>& left_out) const
{
  static const std::set<std::string> others = {"IN", "--list", "--jobs", "--output"};
  std::string text;
  for(const auto& [option, typed] : given)
    if(others.count(option) == 0 && left_out.count(option) == 0)
      text += ' ' + option + '=' + typed;
  return text;
}

void write_json(std::ostream& out, const Json& json)
{
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

std::ostream* Run::out(const std::string& option)
{
  std::ostream*& stream = streams_[option];
  if(stream == nullptr && !file(option).empty())
    stream = &files_.open(file(option));
  return stream;
}

void Run::write(const std::string& option, const Mesh& mesh, const std::vector<Point>& points, Surface surface)
{
  const Stopwatch writing;
  if(std::ostream* const file = out(option))
    write_mesh(*file, mesh_format(option), mesh, points, surface, annotations, data);
  figures.seconds_write += writing.seconds();
}

std::string Run::name_of_input() const { return shown(options.input, "standard input"); }
std::string Run::name_of_output() const { return shown(file(), "standard output"); }

void Run::begin(const Step& step)
{
  has_maps_ = step.takes.method != nullptr || step.takes.sphere == Takes::ARGUMENT;
  for(const Output& output : step.gives)
    if(const std::string& name = file(output.option());
       !name.empty() && output.kind != Output::FOLDER && output.kind != Output::DATABASE)
      Atomic_file(std::string(name)); // or it is refused
}

void Run::write_report()
{
  report_ = Atomic_files();
  if(file("--report").empty())
    return;
  Json json;
  if(has_maps_)
    json = report_json(options, input, figures);
  else {
    json = {{"version", SPHERICAL_PARAMETERIZATION_VERSION}, {"input", options.input}, {"settings", given}};
    if(input.prepared)
      json["preparation"] = sentences(input.prepared->preparation);
  }
  if(options.input.empty())
    json.erase("input");
  if(!details.is_null())
    json.update(details);
  json["seconds"]["write"] = figures.seconds_write;
  json["seconds"]["total"] = figures.seconds_total;
  json["peak_memory_bytes"] = peak_memory_bytes();
  json["error"] = figures.refusal ? Json(figures.refusal->what()) : Json(nullptr);
  json["error_code"] = figures.refusal ? figures.refusal->code() : "OK";
  write_json(report_.open(file("--report")), json);
  report_.complete();
}

void Run::commit(bool is_late)
{
  const Stopwatch writing;
  if(std::ostream* const file = out("--data-output"))
    write_vertex_data(*file, this->file("--data-output"), data, annotations);
  files_.complete();
  figures.seconds_write += writing.seconds();
  figures.seconds_total = total_.seconds();
  write_report();
  if(!is_late)
    stop_if_interrupted(options.input);
  report_.commit();
  files_.commit();
  is_committed_ = true;
}

Outcome perform(const Step& step, const Work& work, Run& run)
{
  watch_for_interruption();
  Outcome outcome;
  outcome.refusal = guarded(run.options.input, [&] {
    run.begin(step);
    work.run(run);
    if(!run.is_committed_)
      run.commit();
  });
  if(outcome.refusal && !was_interrupted()) {
    run.files_ = Atomic_files(); // their space is for the report
    run.figures.refusal = outcome.refusal;
    run.figures.seconds_total = run.total_.seconds();
    guarded(run.options.input, [&] {
      run.write_report();
      run.report_.commit();
    });
  }
  if(!outcome.refusal || outcome.refusal->code() != unwritable_file)
    outcome.text = run.text;
  if(is_verbose() && step.takes.meshes == Takes::EACH && run.has_maps_ && !outcome.text.empty())
    outcome.text += '\n' + verbose_text(run.input.result);
  outcome.line = run.line + (was_mended(run.input.prepared) && !run.line.empty() ? ", prepared" : "");
  return outcome;
}

} // namespace tool
