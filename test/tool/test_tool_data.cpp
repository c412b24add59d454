// SPDX-License-Identifier: GPL-3.0-or-later
// Values and labels at vertices: what is written is read back, here and by the programs of the field, what they write
// is read, what is broken is refused, and every command carries them.

#include "helpers/meshes.h"
#include "helpers/tool.h"

#include "input/binary.h"
#include "input/mesh.h"
#include "input/mesh_format.h"
#include "input/vertex_data.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "output/write_vertex_data.h"
#include "system/refusal.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

using namespace test;
using namespace std::string_literals;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

tool::Mesh mesh_of(const Soup& soup)
{
  std::vector<tool::Point> points;
  for(const Point& p : soup.points)
    points.push_back({p.x(), p.y(), p.z()});
  return tool::Mesh(points, soup.faces);
}

/// Numbers of which some are not floats and some are missing, and labels of which some vertices have none.
tool::Vertex_data columns(std::size_t vertices)
{
  tool::Vertex_data data = {{"thickness", {}}, {"a parcel", {}, true}};
  data[1].table = {
    {0, "unknown", {0, 0, 0, 0}}, {7, "bank, \"s\" & <ts>", {1, 0.2F, 0.4F, 1}}, {3, "\xc3\xa9", {0, 1, 1, 1}}};
  for(std::size_t v = 0; v < vertices; ++v) {
    data[0].values.push_back(v % 5 == 2 ? missing : double(v * 37 % 101) / 7);
    data[1].values.push_back(v % 4 == 0 ? missing : v % 4 == 1 ? 7 : v % 4 == 2 ? 3 : 0);
  }
  return data;
}

bool is_same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void check_values(const tool::Vertex_column& a, const tool::Vertex_column& b, bool are_floats = false)
{
  CAPTURE(a.name, b.name);
  REQUIRE(a.values.size() == b.values.size());
  std::size_t different = 0;
  for(std::size_t v = 0; v < a.values.size(); ++v)
    different += is_same(are_floats ? static_cast<float>(b.values[v]) : b.values[v], a.values[v]) ? 0 : 1;
  CHECK(different == 0);
}

void check_labels(const tool::Vertex_column& a, const tool::Vertex_column& b)
{
  CHECK(a.is_label);
  check_values(a, b);
  REQUIRE(a.table.size() == b.table.size());
  std::map<int, std::pair<std::string, std::array<float, 4>>> of_a, of_b;
  for(std::size_t i = 0; i < a.table.size(); ++i) {
    of_a[a.table[i].key] = {a.table[i].name, a.table[i].rgba};
    of_b[b.table[i].key] = {b.table[i].name, b.table[i].rgba};
  }
  CHECK(of_a == of_b);
}

void write_data(const std::string& file, const tool::Vertex_data& data)
{
  tool::Atomic_files out;
  tool::write_vertex_data(out.open(file), file, data);
  out.commit();
}

void write_mesh(const std::string& file, const tool::Mesh& mesh, const tool::Vertex_data& data, bool is_text = false)
{
  tool::Atomic_files out;
  tool::write_mesh(out.open(file), {*tool::format_of_name(file), is_text}, mesh, mesh.points(), tool::Surface::SHAPE,
                   {}, data);
  out.commit();
}

std::string refusal(const std::string& file, std::size_t vertices)
{
  try {
    tool::read_vertex_data(file, vertices);
  } catch(const tool::Refusal& refusal) {
    return refusal.what();
  }
  return "not refused";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Runs a program of Python, which exits with 77 where a module is not there.
void check_python(const std::string& program, const std::string& folder)
{
  const Process_result judge = run_process({"/usr/bin/python3", "-W", "ignore", "-c", program, folder});
  if(judge.exit_code == 77 || judge.exit_code == 127)
    std::cout << "SKIPPED: " << judge.out << std::endl;
  else {
    CAPTURE(judge.out, judge.err);
    CHECK(judge.exit_code == 0);
  }
}

} // namespace

TEST_CASE("data: files of data are read back as they were written", "[tool][data]")
{
  Scratch scratch;
  const tool::Vertex_data data = columns(42);
  const auto read = [&](const char* name) {
    CAPTURE(name);
    write_data(scratch / name, data);
    return tool::read_vertex_data(scratch / name, 42);
  };
  for(const char* name : {"out.func.gii", "out.shape.gii.gz", "lh.thickness"}) {
    const tool::Vertex_data found = read(name);
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == "thickness");
    CHECK_FALSE(found[0].is_label);
    check_values(found[0], data[0], true);
  }
  for(const char* name : {"out.label.gii", "lh.parcel.annot"}) {
    const tool::Vertex_data found = read(name);
    REQUIRE(found.size() == 1);
    CHECK(found[0].name == (contains(name, ".gii") ? "a parcel" : "parcel"));
    tool::Vertex_column expected = data[1];
    for(double& value : expected.values) // black is the colour of 0, and of what has no label in .annot
      value = std::isnan(value) && contains(name, ".annot") ? 0 : value;
    if(contains(name, ".annot")) { // whose keys are numbers of entries
      std::map<int, int> numbers;
      for(const tool::Label& label : data[1].table)
        numbers[label.key] = 0;
      for(auto& [key, number] : numbers)
        number = static_cast<int>(std::distance(numbers.begin(), numbers.find(key)));
      for(tool::Label& label : expected.table)
        label.key = numbers.at(label.key);
      for(double& value : expected.values)
        value = numbers.at(static_cast<int>(value));
    }
    check_labels(found[0], expected);
  }
  const tool::Vertex_data found = read("out.csv");
  REQUIRE(found.size() == 2);
  check_values(found[0], data[0]);
  CHECK(found[1].name == "a parcel");
  REQUIRE(found[1].is_label); // by names; keys are numbered anew
  for(std::size_t v = 0; v < 42; ++v) {
    const auto name_of = [v](const tool::Vertex_column& column) {
      for(const tool::Label& label : column.table)
        if(label.key == column.values[v])
          return label.name;
      return "none"s;
    };
    CHECK(name_of(found[1]) == name_of(data[1]));
  }
}

std::string changed(std::string text, const std::string& from, const std::string& to)
{
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

TEST_CASE("data: surfaces are read back with their columns", "[tool][data]")
{
  Scratch scratch;
  const tool::Mesh mesh = mesh_of(bumpy_sphere(2));
  const tool::Vertex_data data = columns(mesh.number_of_vertices());
  for(const char* name : {"out.ply", "out.vtk", "out.vtp", "out.vtp.gz"})
    for(const bool is_text : {false, true}) {
      CAPTURE(name, is_text);
      write_mesh(scratch / name, mesh, data, is_text);
      const tool::Input_mesh copy = tool::read_mesh(scratch / name);
      CHECK((copy.mesh.points() == mesh.points()));
      REQUIRE(copy.data.size() == 2);
      CHECK(copy.data[0].name == "thickness");
      CHECK(copy.data[1].name == (contains(name, "ply") ? "a_parcel" : "a parcel"));
      check_values(copy.data[0], data[0]);
      CHECK_FALSE(copy.data[0].is_label);
      CHECK(copy.data[1].is_label);
      tool::Vertex_column keys = data[1];
      for(double& value : keys.values)
        value = tool::key_of(value);
      check_values(copy.data[1], keys);
      check_values(tool::read_vertex_data(scratch / name, mesh.number_of_vertices())[0], data[0]);
    }
}

TEST_CASE("data: bytes that look like spaces are numbers where VTK's scalars have no lookup table", "[tool][data]")
{
  Scratch scratch;
  const tool::Mesh mesh = mesh_of(bumpy_sphere(2));
  tool::Vertex_data data = columns(mesh.number_of_vertices());
  data.resize(1);
  data[0].values[0] = std::ldexp(1., -511); // its first byte is a space
  write_mesh(scratch / "out.vtk", mesh, data, false);
  write_text(scratch / "out.vtk", changed(text_of(scratch / "out.vtk"), "LOOKUP_TABLE default\n", ""));
  const tool::Input_mesh copy = tool::read_mesh(scratch / "out.vtk");
  REQUIRE(copy.data.size() == 1);
  check_values(copy.data[0], data[0]);
}

TEST_CASE("data: colours of PLY stay bytes, and normals are left out", "[tool][data]")
{
  Scratch scratch;
  write_text(scratch / "in.ply",
             "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
             "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
             "property short depth\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
             "1 1 1 0 0 1 255 -7\n-1 -1 1 0 0 1 0 2\n-1 1 -1 0 0 1 9 2\n1 -1 -1 0 0 1 8 2\n"
             "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  REQUIRE(run_tool({"map", scratch / "in.ply", "-o", scratch / "out.ply"}).exit_code == 0);
  const std::string text = text_of(scratch / "out.ply");
  CHECK(contains(text, "property double z\nproperty uchar red\nproperty double depth\nelement face"));
  const tool::Vertex_data data = tool::read_mesh(scratch / "out.ply").data;
  REQUIRE(data.size() == 2);
  CHECK(data[0].values == std::vector<double>{255, 0, 9, 8});
  CHECK(data[1].values == std::vector<double>{-7, 2, 2, 2});
}

TEST_CASE("data: nibabel reads what is written here, and its files are read", "[tool][data]")
{
  Scratch scratch;
  const tool::Vertex_data data = columns(42);
  for(const char* name :
      {"out.func.gii", "out.shape.gii", "out.label.gii", "lh.thickness", "lh.out.annot", "lh.out.label", "out.csv"})
    write_data(scratch / name, data);
  check_values(tool::read_vertex_data(scratch / "lh.out.label", 42)[0], data[0]);
  check_python(R"(
import sys
try:
  import nibabel, numpy
except ImportError:
  print('no nibabel (Debian: python3-nibabel)')
  sys.exit(77)
from nibabel.gifti import GiftiDataArray, GiftiImage, GiftiLabel, GiftiLabelTable, GiftiMetaData
import nibabel.freesurfer as fs
folder = sys.argv[1] + '/'
values = numpy.array([numpy.nan if v % 5 == 2 else v * 37 % 101 / 7 for v in range(42)])
keys = numpy.array([-1, 7, 3, 0] * 11)[:42]
for name, intent in ('func', 'none'), ('shape', 'shape'):
  image = nibabel.load(folder + f'out.{name}.gii')
  assert numpy.array_equal(image.agg_data(), values.astype('f4'), equal_nan=True)
  assert image.darrays[0].intent == nibabel.nifti1.intent_codes.code[intent]
  assert image.darrays[0].meta['Name'] == 'thickness'
image = nibabel.load(folder + 'out.label.gii')
assert (image.agg_data('label') == keys).all()
assert image.labeltable.get_labels_as_dict() == {0: 'unknown', 7: 'bank, "s" & <ts>', 3: '\u00e9'}
assert numpy.allclose(image.labeltable.labels[-1].rgba, (1, .2, .4, 1))
assert numpy.array_equal(fs.read_morph_data(folder + 'lh.thickness'), values.astype('f4'), equal_nan=True)
listed, numbers = fs.read_label(folder + 'lh.out.label', read_scalars=True)
assert (listed == numpy.flatnonzero(values == values)).all() and (numbers == values[listed]).all()
index, table, names = fs.read_annot(folder + 'lh.out.annot')
assert list(table[index[1]][:4]) == [255, 51, 102, 0] and names[index[1]] == b'bank, "s" & <ts>'
assert index[0] == index[4] == -1 and index[2] == index[6] != index[1]

fs.write_morph_data(folder + 'rh.curv', values.astype('f4'))
fs.write_annot(folder + 'rh.theirs.annot', numpy.array([-1, 0, 1] * 14), numpy.array([[25, 5, 25, 0], [9, 8, 7, 255]]),
               [b'first', b'second'], fill_ctab=True)
labels = GiftiLabelTable()
for key, name in (4, 'four'), (2, 'two'):
  label = GiftiLabel(key, .5, .25, 1, 1)
  label.label = name
  labels.labels.append(label)
arrays = [GiftiDataArray(numpy.array([4, 2, 0] * 14, dtype='i4'), intent='NIFTI_INTENT_LABEL')]
nibabel.save(GiftiImage(darrays=arrays, labeltable=labels), folder + 'theirs.label.gii')
for encoding in 'ASCII', 'B64BIN', 'B64GZ':
  arrays = [GiftiDataArray(k * numpy.arange(42, dtype='f4'), intent='NIFTI_INTENT_TIME_SERIES', encoding=f'GIFTI_ENCODING_{encoding}',
                           meta=GiftiMetaData({'Name': f'at {k}'}) if k else None) for k in range(3)]
  nibabel.save(GiftiImage(darrays=arrays), folder + f'{encoding}.func.gii')
)",
               scratch.folder());
  if(!std::filesystem::exists(scratch / "theirs.label.gii"))
    return;
  check_values(tool::read_vertex_data(scratch / "rh.curv", 42)[0], data[0], true);
  const tool::Vertex_column annot = tool::read_vertex_data(scratch / "rh.theirs.annot", 42)[0];
  CHECK(annot.table[1].name == "second");
  CHECK(annot.table[1].rgba[0] == 9 / 255.F);
  CHECK(annot.table[1].rgba[3] == 0);
  CHECK((std::isnan(annot.values[0]) && annot.values[1] == 0 && annot.values[2] == 1));
  const tool::Vertex_column label = tool::read_vertex_data(scratch / "theirs.label.gii", 42)[0];
  CHECK(label.is_label);
  CHECK((label.values[0] == 4 && label.values[1] == 2 && std::isnan(label.values[2]))); // 0 is not in their table
  for(const char* name : {"ASCII.func.gii", "B64BIN.func.gii", "B64GZ.func.gii"}) {
    const tool::Vertex_data series = tool::read_vertex_data(scratch / name, 42);
    REQUIRE(series.size() == 3);
    CHECK(series[0].name == std::string(name).substr(0, std::string(name).find('.')));
    CHECK(series[2].name == "at 2");
    CHECK(series[2].values[41] == 82);
  }
}

TEST_CASE("data: meshio reads the surfaces that are written here, and its files are read", "[tool][data]")
{
  Scratch scratch;
  const tool::Mesh mesh = mesh_of(bumpy_sphere(1));
  write_mesh(scratch / "out.ply", mesh, columns(mesh.number_of_vertices()));
  check_python(R"(
import sys
try:
  import meshio, numpy
except ImportError:
  print('no meshio (Debian: python3-meshio)')
  sys.exit(77)
folder = sys.argv[1] + '/'
mesh = meshio.read(folder + 'out.ply')
n = len(mesh.points)
values = numpy.array([numpy.nan if v % 5 == 2 else v * 37 % 101 / 7 for v in range(n)])
assert numpy.array_equal(mesh.point_data['thickness'], values, equal_nan=True)
assert (mesh.point_data['a_parcel'] == numpy.array([-1, 7, 3, 0] * n)[:n]).all()
data = {'height': numpy.arange(n) / 7, 'kind': numpy.arange(n, dtype='i4'), 'vector': numpy.arange(3. * n).reshape(n, 3)}
theirs = meshio.Mesh(mesh.points, {'triangle': mesh.cells_dict['triangle'].astype('i4')}, point_data=data)
for version in '42', '51':
  for kind in True, False:
    meshio.write(folder + f'theirs{version}{kind}.vtk', theirs, file_format='vtk' + version, binary=kind)
del theirs.point_data['vector']
meshio.write(folder + 'theirs.ply', theirs)
)",
               scratch.folder());
  if(!std::filesystem::exists(scratch / "theirs.ply"))
    return;
  for(const char* name :
      {"theirs42True.vtk", "theirs42False.vtk", "theirs51True.vtk", "theirs51False.vtk", "theirs.ply"}) {
    CAPTURE(name);
    const tool::Input_mesh copy = tool::read_mesh(scratch / name);
    CHECK((copy.mesh.points() == mesh.points()));
    REQUIRE(copy.data.size() == (contains(name, "vtk") ? 5 : 2));
    CHECK(copy.data[0].name == "height");
    CHECK(copy.data[0].values[20] == 20 / 7.);
    CHECK(copy.data[1].is_label);
    CHECK(copy.data[1].values[20] == 20);
    if(copy.data.size() == 5)
      CHECK((copy.data[4].name == "vector_2" && copy.data[4].values[20] == 62));
  }
}

TEST_CASE("data: VTK reads the surfaces that are written here, and its files are read", "[tool][data]")
{
  Scratch scratch;
  const tool::Mesh mesh = mesh_of(bumpy_sphere(1));
  tool::Vertex_data data = columns(mesh.number_of_vertices());
  for(const char* name : {"bytes.vtk", "bytes.vtp"})
    write_mesh(scratch / name, mesh, data);
  for(double& value : data[0].values) // VTK does not read NaN in text
    value = std::isnan(value) ? 0 : value;
  for(const char* name : {"text.vtk", "text.vtp"})
    write_mesh(scratch / name, mesh, data, true);
  check_python(R"(
import sys
try:
  import numpy
  from vtkmodules.vtkCommonCore import vtkStringArray
  from vtkmodules.vtkFiltersCore import vtkAppendFilter
  from vtkmodules.vtkIOLegacy import vtkPolyDataReader, vtkPolyDataWriter, vtkUnstructuredGridWriter
  from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLPolyDataWriter, vtkXMLUnstructuredGridWriter
  from vtkmodules.util.numpy_support import vtk_to_numpy
except ImportError:
  print('no VTK (Debian: python3-vtk9)')
  sys.exit(77)
folder = sys.argv[1] + '/'
for name in 'bytes.vtk', 'text.vtk', 'bytes.vtp', 'text.vtp':
  reader = vtkPolyDataReader() if name.endswith('vtk') else vtkXMLPolyDataReader()
  reader.SetFileName(folder + name)
  if name.endswith('vtk'):
    reader.ReadAllScalarsOn()
  reader.Update()
  mesh = reader.GetOutput()
  n = mesh.GetNumberOfPoints()
  none = numpy.nan if name.startswith('bytes') else 0
  values = numpy.array([none if v % 5 == 2 else v * 37 % 101 / 7 for v in range(n)])
  assert n > 0 and mesh.GetNumberOfPolys() == 2 * n - 4, name
  assert numpy.array_equal(vtk_to_numpy(mesh.GetPointData().GetArray('thickness')), values, equal_nan=True), name
  assert (vtk_to_numpy(mesh.GetPointData().GetArray('a parcel')) == numpy.array([-1, 7, 3, 0] * n)[:n]).all(), name
texts = vtkStringArray() # which are left out
texts.SetName('texts')
for v in range(n):
  texts.InsertNextValue('some text' * (v % 9 * 1000))
mesh.GetPointData().AddArray(texts)
append = vtkAppendFilter()
append.AddInputData(mesh)
append.Update()
for version in 42, 51:
  for kind in 1, 2:
    for of in vtkPolyDataWriter, vtkUnstructuredGridWriter:
      writer = of()
      writer.SetFileVersion(version)
      writer.SetFileType(kind)
      writer.SetFileName(folder + f'theirs{of.__name__}{version}{kind}.vtk')
      writer.SetInputData(mesh if of is vtkPolyDataWriter else append.GetOutput())
      assert writer.Write()
for mode in 'Ascii', 'Binary', 'Appended':
  writer = vtkXMLUnstructuredGridWriter()
  getattr(writer, f'SetDataModeTo{mode}')()
  writer.SetFileName(folder + f'theirs{mode}.vtu')
  writer.SetInputData(append.GetOutput())
  assert writer.Write()
for mode in 'Ascii', 'Binary', 'Appended':
  for compressor in 'None', 'ZLib':
    for encoded in 0, 1:
      for order in 'BigEndian', 'LittleEndian':
        writer = vtkXMLPolyDataWriter()
        getattr(writer, f'SetDataModeTo{mode}')()
        getattr(writer, f'SetCompressorTypeTo{compressor}')()
        getattr(writer, f'SetByteOrderTo{order}')()
        writer.SetHeaderTypeToUInt64() if encoded else writer.SetHeaderTypeToUInt32()
        writer.SetEncodeAppendedData(encoded)
        writer.SetBlockSize(256)
        writer.SetFileName(folder + f'theirs{mode}{compressor}{encoded}{order}.vtp')
        writer.SetInputData(mesh)
        assert writer.Write()
)",
               scratch.folder());
  std::size_t number = 0;
  for(const auto& entry : std::filesystem::directory_iterator(scratch.folder()))
    if(const std::string name = entry.path().filename(); name.compare(0, 6, "theirs") == 0) {
      CAPTURE(name);
      const tool::Input_mesh copy = tool::read_mesh(entry.path());
      ++number;
      // as text VTK has eleven digits
      bool is_near = copy.mesh.number_of_faces() == mesh.number_of_faces();
      for(std::size_t v = 0; is_near && v < mesh.number_of_vertices(); ++v)
        for(std::size_t k = 0; k < 3; ++k)
          is_near = is_near && std::abs(copy.mesh.points()[v][k] - mesh.points()[v][k]) < 1e-5;
      CHECK(is_near);
      REQUIRE(copy.data.size() == 2);
      const std::size_t labels = copy.data[0].is_label ? 0 : 1;
      CHECK(copy.data[labels].name == "a parcel");
      CHECK(copy.data[labels].values[1] == 7);
      CHECK(copy.data[1 - labels].values[1] == Approx(37 / 7.));
    }
  CHECK((number == 0 || number == 35));
}

TEST_CASE("data: broken files are refused in one line", "[tool][data]")
{
  Scratch scratch;
  const tool::Mesh mesh = mesh_of(icosphere(1));
  const tool::Vertex_data data = columns(42);
  const auto check = [&](const std::string& name, const std::string& content, const std::string& word) {
    write_text(scratch / name, content);
    const std::string text = refusal(scratch / name, 42);
    CAPTURE(name, word, text);
    CHECK(contains(text, word));
    CHECK(contains(text, name));
    CHECK_FALSE(contains(text, "\n"));
    CHECK(contains(text, "; ")); // what to do
  };
  const auto good = [&](const std::string& name) {
    write_data(scratch / name, data);
    return text_of(scratch / name);
  };

  SECTION("curv")
  {
    const std::string bytes = good("lh.thickness");
    check("lh.thickness", bytes.substr(0, bytes.size() - 1), "bytes");
    check("lh.thickness", bytes.substr(0, 9), "cut short");
    check("lh.thickness", bytes + "x", "bytes");
    check("lh.thickness", std::string(bytes).replace(3, 4, "\x7f\xff\xff\xff"), "bytes");
    check("lh.thickness", std::string(bytes).replace(11, 4, "\0\0\0\2"s), "2 values per vertex");
    write_text(scratch / "lh.thickness", bytes);
    CHECK(contains(refusal(scratch / "lh.thickness", 43), "values for 42 vertices, but the mesh has 43"));
    CHECK(contains(refusal(scratch / "missing", 42), "does not exist"));
    check("lh.curv", "\0\0\3\0\0\1\0\1\0\2\xff\xff"s, "values for 3 vertices"); // the old format
  }
  SECTION("annot")
  {
    const std::string bytes = good("lh.a.annot");
    check("lh.a.annot", bytes.substr(0, 4 + 8 * 42), "no table of colours");
    for(std::size_t size = 4 + 8 * 42 + 4; size < bytes.size(); size += 3)
      check("lh.a.annot", bytes.substr(0, size), "lh.a.annot");
    check("lh.a.annot", std::string(bytes).replace(4, 4, "\0\0\1\0"s), "range 0..41");
    check("lh.a.annot", std::string(bytes).replace(0, 4, "\x7f\xff\xff\xff"), "announces");
    check("lh.a.annot", changed(bytes, "\xff\xff\xff\xfe"s, "\xff\xff\xff\xf0"s), "version 16");
  }
  SECTION("label")
  {
    check("lh.a.label", "#!ascii label\n2\n1 0 0 0 0.5\n", "announces 2 vertices and has 1");
    check("lh.a.label", "#!ascii label\n1\n42 0 0 0 0.5\n", "range 0..41");
    check("lh.a.label", "#!ascii label\n1\n4 0 0 0.5\n", "not a number");
    check("lh.a.label", "#!ascii label\nx\n", "number of the lines");
  }
  SECTION("CSV")
  {
    std::string text = good("a.csv");
    check("a.csv", text + "1,2\n", "43 vertices");
    check("a.csv", text.substr(0, text.rfind(',')), "quotation mark has no end");
    check("a.csv", changed(text, "\n", "\n1,2,3\n"), "vertex 0: 3 values");
    check("a.csv", "1,2\n3,4\n", "only numbers");
    check("a.csv", ",a\n3,4\n", "index=False");
  }
  SECTION("GIFTI")
  {
    const std::string text = good("a.label.gii");
    check("a.label.gii", changed(text, "Dim0=\"42", "Dim0=\"41"), "decompressed to the size");
    check("a.label.gii", changed(text, "Dim0=\"42", "Dim0=\"-1"), "Dim0");
    check("a.label.gii", changed(text, "Dim0=\"42", "Dim0=\"99999999"), "cut short");
    check("a.label.gii", changed(text, "Dimensionality=\"1", "Dimensionality=\"3"), "one number per vertex");
    check("a.label.gii", changed(text, "Key=\"7\"", "Key=\"3\""), "key '3'");
    check("a.label.gii", changed(text, "Key=\"7\"", "Key=\"x\""), "key 'x'");
    check("a.label.gii", changed(text, "</DataArray>", "</DataArra>"), "line ");
    check("a.label.gii", changed(text, "<Data>", "<Dada>"), "line ");
    check("a.label.gii", "<GIFTI/>", "no values");
  }
  SECTION("surfaces")
  {
    for(const char* name : {"a.vtk", "a.vtp"})
      for(const bool is_text : {false, true}) {
        write_mesh(scratch / name, mesh, data, is_text);
        const std::string bytes = text_of(scratch / name);
        for(std::size_t share = 1; share < 16; ++share) {
          write_text(scratch / name, bytes.substr(0, share * bytes.size() / 16));
          const std::string text = refusal(scratch / name, 42);
          CAPTURE(name, is_text, share, text);
          CHECK(contains(text, name));
        }
      }
    write_mesh(scratch / "a.vtk", mesh, data, true);
    std::string text = text_of(scratch / "a.vtk");
    check("a.vtk", changed(text, "POINTS 42", "POINTS 99999999"), "cut short");
    check("a.vtk", changed(text, "POINTS 42", "POINTS -1"), "count '-1'");
    check("a.vtk", changed(text, "POINT_DATA 42", "POINT_DATA 41"), "41 points, and 42 points");
    check("a.vtk", changed(text, "POLYDATA", "STRUCTURED_GRID"), "PolyData");
    check("a.vtk", changed(text, "\n3 ", "\n2 "), "2 vertices");
    check("a.vtk", changed(text, "\n3 0 ", "\n3 42 "), "0..41");
    check("a.vtk", changed(text, "ASCII", "TEXT"), "neither ASCII nor BINARY");
    check("a.vtk", changed(text, " double\nLOOKUP", " strange\nLOOKUP"), "'strange'");
    check("a.vtk", changed(text, "SCALARS", "SCALAR"), "keyword");
    write_mesh(scratch / "a.vtp", mesh, data, true);
    text = text_of(scratch / "a.vtp");
    check("a.vtp", changed(text, ">\n3\n6", ">\n0\n6"), "not in order"); // ends of faces
    check("a.vtp", changed(text, ">\n3\n6", ">\n.5\n6"), "not in order");
    check("a.vtp",
          "<VTKFile type='PolyData'><PolyData><Piece NumberOfPoints='0'><Points><DataArray type='Float32' "
          "format='ascii'/></Points><PointData><DataArray type='String' format='ascii'>97 0</DataArray>"
          "</PointData></Piece></PolyData></VTKFile>",
          "no faces"); // the texts are no trouble
    const std::string grid = "# vtk DataFile Version 3.0\ngrid\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n"
                             "0 0 0 1 0 0 0 1 0\nCELLS 2 6\n1 0\n3 0 1 2\n";
    check("a.vtk", grid, "CELLS without CELL_TYPES");
    check("a.vtk", grid + "CELL_TYPES 2\n1\n10\n", "cell 1 is no face");
    check("a.vtk", grid + "CELL_TYPES 2\n1\n5.5\n", "cell 1 is no face");
    check("a.vtk", grid + "CELL_TYPES 2\n1\n9\n", "face 1 has 3 vertices");
    check("a.vtk", grid + "CELL_TYPES 2\n5\n5\n", "face 0 has only 1 vertices");
    check("a.vtk", grid + "CELL_TYPES 3\n1\n5\n5\n", "the types of 3 cells, and 2 cells");
    check("a.vtk", grid + "CELL_TYPES 2\n1\n5\nPOINT_DATA 3\nPEDIGREE_IDS ids string\na\nb\n", "cut short");
    check("a.vtk", "# vtk DataFile Version 3.0\ntext\nBINARY\nFIELD f 1\nname 1 1 string\n\xff!", "a text of 63 bytes");
    check("a.vtp", changed(text, "NumberOfPoints=\"42", "NumberOfPoints=\"43"), "size");
    check("a.vtp", changed(text, "NumberOfPolys=\"80", "NumberOfPolys=\"81"), "size");
    check("a.vtp", changed(text, "\"PolyData\"", "\"ImageData\""), "PolyData");
    check("a.vtp", changed(text, "vtkZLib", "vtkLZ4"), "zlib");
    check("a.vtp", changed(text, "Float64", "Floaty"), "'Floaty'");
    check("a.vtp", changed(text, "\"connectivity\"", "\"corners\""), "connectivity");
    write_mesh(scratch / "a.vtp", mesh, data);
    text = text_of(scratch / "a.vtp");
    check("a.vtp", changed(text, ">\nAQAA", ">\nBQAA"), "a.vtp");
    check("a.vtp", changed(text, ">\nAQAA", ">\n????"), "Base64");
  }
}

TEST_CASE("data: colours in the text of VTK files are shares of 255", "[tool][data]")
{
  Scratch scratch;
  write_text(scratch / "in.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n"
                                 "0 0 0 1 0 0 0 1 0 0 0 1\nPOLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"
                                 "POINT_DATA 4\nCOLOR_SCALARS c 1\n0\n0.498039\n1\n0.8\n");
  CHECK(tool::read_vertex_data(scratch / "in.vtk", 4).at(0).values == std::vector<double>{0, 127, 255, 204});
}

TEST_CASE("data: what a format cannot hold is refused, not written", "[tool][data]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(1));
  write_data(scratch / "in.csv", columns(42));
  const auto check = [&](const std::string& data, const std::string& name, int exit_code, const std::string& word) {
    const Process_result run =
      run_tool({"map", input, "-o", scratch / "out.ply", "--data", scratch / data, "--data-output", scratch / name});
    CAPTURE(name, run.out, run.err);
    CHECK(run.exit_code == exit_code);
    CHECK(contains(run.err, word));
    CHECK(std::filesystem::exists(scratch / name) == (exit_code == 0));
    CHECK(std::filesystem::exists(scratch / "out.ply") == (exit_code == 0));
    std::filesystem::remove(scratch / "out.ply");
  };
  check("in.csv", "lh.out.annot", 0, "");
  check("in.csv", "lh.out", 0, "");
  check("lh.out", "out.label.gii", 1, "no columns of labels");
  check("lh.out.annot", "out.func.gii", 1, "no columns of numbers");
  check("in.csv", "out.gii", 2, "must be called");
  check("in.csv", "out.label", 0, "");
  write_text(
    scratch / "two.csv", "a,b\n" + [] {
      std::string rows;
      for(int v = 0; v < 42; ++v)
        rows += "1,2\n";
      return rows;
    }());
  check("two.csv", "lh.two", 1, "holds one column");
  check("two.csv", "two.shape.gii", 0, "");
  std::string large = "a\n1e300\n";
  for(int v = 1; v < 42; ++v)
    large += "1\n";
  write_text(scratch / "large.csv", large);
  for(const char* name : {"large.func.gii", "large.shape.gii", "lh.large"})
    check("large.csv", name, 1, "holds floats, and 'a' has larger numbers");
  check("large.csv", "copy.csv", 0, "");
}

TEST_CASE("data: blanks beside commas are no part of numbers and names", "[tool][data]")
{
  Scratch scratch;
  write_text(scratch / "in.csv", "a, b ,\tc, \" d \" \n1, 20, x y , \" z\"\n 3 ,\"40\" ,x y,w\n");
  const tool::Vertex_data data = tool::read_vertex_data(scratch / "in.csv", 2);
  REQUIRE(data.size() == 4);
  CHECK((data[0].name == "a" && data[1].name == "b" && data[2].name == "c" && data[3].name == " d "));
  CHECK((data[0].values == std::vector<double>{1, 3}));
  CHECK((data[1].values == std::vector<double>{20, 40}));
  CHECK((data[2].is_label && data[2].values[0] == data[2].values[1]));
  CHECK((data[3].is_label && data[3].values[0] != data[3].values[1]));
  write_data(scratch / "out.csv", data); // and are read as they were
  const tool::Vertex_data again = tool::read_vertex_data(scratch / "out.csv", 2);
  REQUIRE(again.size() == 4);
  CHECK(again[3].name == " d ");
  CHECK(again[3].table.size() == data[3].table.size());
  for(std::size_t k = 0; k < data[3].table.size(); ++k)
    CHECK(again[3].table[k].name == data[3].table[k].name);
  for(const char* name : {"1", "inf", "\"inf\", so to say", "no information"}) {
    write_data(scratch / "out.csv", {{name, {1, 2}}, {"b", {3, 4}}});
    CHECK(tool::read_vertex_data(scratch / "out.csv", 2).at(0).name == name);
  }
  write_text(scratch / "in.csv", "a,b\n1,2\n3,4\n\n \n");
  CHECK(tool::read_vertex_data(scratch / "in.csv", 2).at(1).values == std::vector<double>{2, 4});
  write_text(scratch / "in.csv", "\"a;b\"\n1\n3\n");
  CHECK(tool::read_vertex_data(scratch / "in.csv", 2).at(0).name == "a;b");
  write_text(scratch / "in.csv", "a;b\n1;2\n3;4\n");
  CHECK_THROWS_WITH(tool::read_vertex_data(scratch / "in.csv", 2), Catch::Contains("separate columns by commas"));
}

TEST_CASE("data: rows of GIFTI go to the vertices that an array of indices names", "[tool][data]")
{
  Scratch scratch;
  const auto array = [](const std::string& intent, const std::string& type, const std::string& numbers) {
    return "<DataArray Intent=\"NIFTI_INTENT_" + intent + "\" DataType=\"NIFTI_TYPE_" + type +
           "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"1\" Dim0=\"2\" Encoding=\"ASCII\" "
           "Endian=\"LittleEndian\" ExternalFileName=\"\" ExternalFileOffset=\"\"><Data>" +
           numbers + "</Data></DataArray>";
  };
  const auto read = [&](const std::string& indices) {
    write_text(scratch / "in.shape.gii", "<?xml version=\"1.0\"?><GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">" +
                                           array("NODE_INDEX", "INT32", indices) +
                                           array("SHAPE", "FLOAT32", "1.5 2.5") + "</GIFTI>");
    return tool::read_vertex_data(scratch / "in.shape.gii", 4);
  };
  const tool::Vertex_data data = read("3 0");
  REQUIRE(data.size() == 1);
  REQUIRE(data[0].values.size() == 4);
  CHECK((data[0].values[0] == 2.5 && data[0].values[3] == 1.5));
  CHECK((std::isnan(data[0].values[1]) && std::isnan(data[0].values[2])));
  for(const char* wrong : {"3 3", "3 4", "-1 0", "1.5 0"})
    CHECK_THROWS_AS(read(wrong), tool::Refusal);
}

TEST_CASE("data: words and lines of CSV files of other programs", "[tool][data]")
{
  Scratch scratch;
  const auto read = [&](const std::string& text) {
    write_text(scratch / "in.csv", text);
    return tool::read_vertex_data(scratch / "in.csv", 2);
  };
  const tool::Vertex_data words = read("a\nfront\nNaN\n");
  CHECK((words[0].is_label && words[0].table.size() == 1 && std::isnan(words[0].values[1])));
  CHECK(read("a,b\r1,2\r3,4\r").at(1).values == std::vector<double>{2, 4});
  tool::Vertex_data numbers = read("\"1\",\"2\"\n1,2\n3,4\n");
  CHECK(numbers.at(1).name == "2");
  write_data(scratch / "out.csv", numbers);
  CHECK(tool::read_vertex_data(scratch / "out.csv", 2).at(0).values == std::vector<double>{1, 3});
  write_text(scratch / "in.vtk", "# vtk DataFile Version 3.0\nlabels\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                                 "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS key int 1\n"
                                 "LOOKUP_TABLE default\n-2147483648 3 2147483647\n");
  CHECK(tool::read_vertex_data(scratch / "in.vtk", 3).at(0).is_label);
}

TEST_CASE("data: .annot numbers labels by their keys, whatever these are", "[tool][data]")
{
  Scratch scratch;
  tool::Vertex_data data = {columns(42)[1]};
  const std::string name = data[0].table[1].name;
  for(const int key : {std::numeric_limits<int>::max(), std::numeric_limits<int>::min()}) {
    for(double& value : data[0].values)
      value = value == data[0].table[1].key ? key : value;
    data[0].table[1].key = key;
    write_data(scratch / "lh.a.annot", data);
    const tool::Vertex_column found = tool::read_vertex_data(scratch / "lh.a.annot", 42).at(0);
    REQUIRE(found.table.size() == 3);
    for(int k = 0; k < 3; ++k)
      CHECK(found.table[k].key == k);
    CHECK(found.table[key < 0 ? 0 : 2].name == name);
  }
}

TEST_CASE("data: columns of one name get numbers, however many there are", "[tool][data]")
{
  Scratch scratch;
  constexpr std::size_t columns = 20000; // where each was compared with all others, this took minutes
  std::string names = "a,a_2,a", values = "1,2,3";
  for(std::size_t k = 3; k < columns; ++k) {
    names += ",a";
    values += ",4";
  }
  write_text(scratch / "in.csv", names + '\n' + values + '\n');
  const tool::Vertex_data data = tool::read_vertex_data(scratch / "in.csv", 1);
  REQUIRE(data.size() == columns);
  CHECK((data[0].name == "a" && data[1].name == "a_2" && data[2].name == "a_3"));
  CHECK(data.back().name == "a_20000");
  CHECK(data[2].values[0] == 3);
}

TEST_CASE("data: columns of no points are none", "[tool][data]")
{
  Scratch scratch;
  write_text(scratch / "in.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 0 float\n"
                                 "POINT_DATA 0\nFIELD f 1\na 2000000000 0 float\n");
  write_text(scratch / "in.vtp",
             "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"0\" NumberOfPolys=\"0\"><Points>"
             "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\"/></Points><PointData><DataArray "
             "type=\"Float32\" Name=\"a\" NumberOfComponents=\"600000000\" format=\"ascii\"/></PointData></Piece>"
             "</PolyData></VTKFile>");
  for(const char* name : {"in.vtk", "in.vtp"}) {
    const std::string text = refusal(scratch / name, 0);
    CAPTURE(text);
    CHECK(contains(text, name));
    CHECK(contains(text, "; "));
  }
}

TEST_CASE("data: bytes of names that are no UTF-8 are replaced in XML", "[tool][data]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(0));
  const std::vector<std::pair<std::string, std::string>> names = {{"H\xc3\xb6he", "H\xc3\xb6he"},
                                                                  {"H\xf6he", "H\xef\xbf\xbdhe"},
                                                                  {"\xf0\x9f\x99\x82", "\xf0\x9f\x99\x82"},
                                                                  {"x\xe2\x82", "x\xef\xbf\xbd\xef\xbf\xbd"},
                                                                  {"\xc0\xaf", "\xef\xbf\xbd\xef\xbf\xbd"}};
  for(const auto& [name, written] : names) {
    std::string text = name + '\n';
    for(int v = 0; v < 12; ++v)
      text += "0.5\n";
    write_text(scratch / "in.csv", text);
    for(const char* output : {"out.vtp", "out.func.gii"}) {
      CAPTURE(name, output);
      const Process_result run = run_tool({"map", input, "-o", scratch / "out.vtp", "--data", scratch / "in.csv",
                                           "--data-output", scratch / "out.func.gii"});
      CAPTURE(run.err);
      REQUIRE(run.exit_code == 0);
      CHECK(contains(text_of(scratch / output), written));
      CHECK((name == written || !contains(text_of(scratch / output), name)));
    }
  }
}

TEST_CASE("data: a colour has one type, also where parts of it are nowhere more than 1", "[tool][data]")
{
  Scratch scratch;
  const std::string input = write_off(scratch / "in.off", icosphere(0));
  std::string text = "red,green,blue\n";
  for(int v = 0; v < 12; ++v)
    text += "0,255,1\n";
  write_text(scratch / "in.csv", text);
  REQUIRE(run_tool({"map", input, "-o", scratch / "out.ply", "--data", scratch / "in.csv"}).exit_code == 0);
  CHECK(contains(text_of(scratch / "out.ply"), "property uchar red\nproperty uchar green\nproperty uchar blue\n"));
  for(const char* beyond : {"0,65535,1", "-1,255,1", "0,255,"}) { // which no byte holds
    write_text(scratch / "in.csv", std::string(text).replace(text.find('\n') + 1, 7, beyond));
    REQUIRE(run_tool({"map", input, "-o", scratch / "out.ply", "--data", scratch / "in.csv"}).exit_code == 0);
    CHECK(contains(text_of(scratch / "out.ply"), "property double red\nproperty double green\nproperty double blue\n"));
  }
}

TEST_CASE("data: of many meshes, one without columns is refused, and the others are done", "[tool][data]")
{
  Scratch scratch;
  const std::string folder = scratch / "in";
  std::filesystem::create_directory(folder);
  write_off(scratch / "a.off", icosphere(1));
  write_data(scratch / "in.csv", columns(42));
  for(const char* name : {"/a.ply", "/c.ply"})
    REQUIRE(run_tool({"map", scratch / "a.off", "-o", folder + name, "--data", scratch / "in.csv"}).exit_code == 0);
  write_off(folder + "/b.off", icosphere(1));
  const Process_result run = run_tool({"map", folder, "-o", scratch / "out", "--data-output", "x.func.gii", "-j", "1"});
  CAPTURE(run.out, run.err);
  CHECK(run.exit_code == 1);
  CHECK(contains(run.out, "b.x.func.gii: there are no columns of numbers to write"));
  CHECK(contains(run.out, "3 meshes, 1 refused"));
  CHECK(std::filesystem::exists(scratch / "out/c.x.func.gii"));
  CHECK_FALSE(std::filesystem::exists(scratch / "out/b.ply"));
}

TEST_CASE("data: every command carries it", "[tool][data]")
{
  Scratch scratch;
  const Soup soup = bumpy_sphere(3);
  const std::size_t n = soup.points.size();
  const std::string input = write_off(scratch / "in.off", soup);
  tool::Vertex_data data = columns(n);
  for(std::size_t v = 0; v < n; ++v)
    data[0].values[v] = soup.points[v].z();
  write_data(scratch / "in.csv", data);
  write_data(scratch / "lh.in.annot", data);
  const tool::Vertex_data given = {tool::read_vertex_data(scratch / "in.csv", n)[0],
                                   tool::read_vertex_data(scratch / "lh.in.annot", n)[0]};
  write_data(scratch / "lh.height", data);
  const auto run = [&](std::vector<std::string> arguments, bool has_z = true) {
    arguments.push_back("--data");
    arguments.push_back(scratch / (has_z ? "lh.height" : "in.csv"));
    arguments.push_back(scratch / "lh.in.annot");
    const Process_result result = run_tool(arguments);
    CAPTURE(arguments, result.err);
    REQUIRE(result.exit_code == 0);
  };
  const auto check_same = [&](const tool::Vertex_data& found) {
    REQUIRE(found.size() == 2);
    CHECK(found[0].name == "height");
    check_values(found[0], given[0], true);
    check_values(found[1], [&] {
      tool::Vertex_column keys = given[1];
      for(double& value : keys.values)
        value = tool::key_of(value);
      return keys;
    }());
  };

  SECTION("map, harmonics, register, morph and segment keep the vertices")
  {
    run({"map", input, "-o", scratch / "map.vtp", "--data-output", scratch / "map.label.gii"});
    check_same(tool::read_mesh(scratch / "map.vtp").data);
    check_labels(tool::read_vertex_data(scratch / "map.label.gii", n)[0], given[1]);
    const std::vector<std::string> sphere = {"--sphere", scratch / "map.vtp"};
    run({"harmonics", input, "--sphere", scratch / "map.vtp", "-o", scratch / "out.csv", "--reconstruct",
         scratch / "out.vtk", "--degree", "4"});
    check_same(tool::read_mesh(scratch / "out.vtk").data);
    run({"segment", input, "--sphere", scratch / "map.vtp", "-o", scratch / "out.ply"});
    check_same(tool::read_mesh(scratch / "out.ply").data);
    write_off(scratch / "b.off", icosphere(2));
    run({"register", input, scratch / "b.off", "-o", scratch / "b.ply", "--data-output", scratch / "b.func.gii"});
    check_same(tool::read_mesh(scratch / "b.ply").data);
    check_values(tool::read_vertex_data(scratch / "b.func.gii", n)[0], given[0], true);
    run({"morph", input, scratch / "b.off", "-o", scratch / "morph", "--steps", "1"});
    check_same(tool::read_mesh(scratch / "morph/step_0.ply").data);
    check_same(tool::read_mesh(scratch / "morph/step_1.ply").data);
  }
  SECTION("prepare: vertices that are kept keep theirs, and new ones get none")
  {
    Soup open = soup;
    std::set<std::size_t> removed;
    for(std::size_t f = 0; f < open.faces.size(); ++f)
      if(open.faces[f][0] == 0 || open.faces[f][1] == 0 || open.faces[f][2] == 0)
        removed.insert(f);
    for(auto f = removed.rbegin(); f != removed.rend(); ++f)
      open.faces.erase(open.faces.begin() + std::ptrdiff_t(*f));
    write_off(scratch / "open.off", open);
    run({"prepare", scratch / "open.off", "-o", scratch / "closed.ply", "--vertex-map", scratch / "old.txt",
         "--data-output", scratch / "closed.csv"},
        false);
    const tool::Input_mesh closed = tool::read_mesh(scratch / "closed.ply");
    const std::vector<std::string> old = lines_of(text_of(scratch / "old.txt"));
    REQUIRE(old.size() == closed.mesh.number_of_vertices());
    REQUIRE(closed.data.size() == 3);
    for(std::size_t v = 0; v < old.size(); ++v)
      CHECK(is_same(closed.data[0].values[v], old[v] == "-1" ? missing : given[0].values[std::stoul(old[v])]));
    CHECK(tool::read_vertex_data(scratch / "closed.csv", old.size()).size() == 3);
    run({"harmonics", scratch / "open.off", "--prepare", "--degree", "4", "-o", scratch / "out.json", "--reconstruct",
         scratch / "smooth.ply"},
        false);
    const tool::Vertex_data smooth = tool::read_mesh(scratch / "smooth.ply").data;
    REQUIRE(smooth.size() == 3);
    for(std::size_t k = 0; k < 3; ++k)
      check_values(smooth[k], closed.data[k]);
  }
  SECTION("resample: numbers are interpolated, labels are not")
  {
    run({"resample", input, "-o", scratch / "out.vtp", "--level", "4"});
    const tool::Input_mesh out = tool::read_mesh(scratch / "out.vtp");
    REQUIRE(out.data.size() == 2);
    double largest = 0;
    for(std::size_t v = 0; v < out.mesh.number_of_vertices(); ++v) {
      largest = std::max(largest, std::abs(out.data[0].values[v] - out.mesh.points()[v][2]));
      CHECK(std::set<double>{-1, 0, 1, 2}.count(out.data[1].values[v]) == 1);
    }
    CHECK(largest < 1e-6); // z is linear on every face; it was read as floats
  }
  SECTION("resample: areas count if that is asked for")
  {
    const std::string sphere = write_off(scratch / "sphere.off", icosphere(2)), csv = scratch / "out.csv";
    const std::vector<std::string> command = {"resample", input,           "-o", scratch / "out.ply", "--to-sphere",
                                              sphere,     "--data-output", csv};
    const auto resampled = [&](const std::vector<std::string>& options) {
      std::vector<std::string> all = command;
      all.insert(all.end(), options.begin(), options.end());
      run(all);
      return tool::read_vertex_data(csv, 162);
    };
    const tool::Vertex_data linear = resampled({});
    const tool::Vertex_data kept = resampled({"--data-weights", "area-preserving"});
    std::size_t different = 0;
    for(std::size_t v = 0; v < 162; ++v)
      different += linear[0].values[v] == kept[0].values[v] ? 0 : 1;
    CHECK(different > 150); // the new mesh is coarser
    const std::string output = scratch / "new.ply";
    write_text(output, text_of(scratch / "out.ply"));
    const std::vector<std::string> surfaces = {"--data-weights", "area-preserving", "--area-surfaces", input,
                                               output}; // what is taken without them
    const tool::Vertex_data same = resampled(surfaces);
    check_values(same[0], kept[0]);
    check_values(same[1], kept[1]);
    CHECK(resampled({"--data-labels", "nearest"})[1].values != kept[1].values);
    for(const auto& [options, exit_code] :
        {std::pair(std::vector<std::string>{"--area-surfaces", input, input}, 2),
         std::pair(std::vector<std::string>{"--data-weights", "area-preserving", "--area-surfaces", input, input},
                   1)}) {
      std::vector<std::string> all = command;
      all.insert(all.end(), options.begin(), options.end());
      all.insert(all.end(), {"--data", scratch / "lh.height"});
      CHECK(run_tool(all).exit_code == exit_code);
    }
  }
  SECTION("another mesh's data is refused")
  {
    write_off(scratch / "other.off", icosphere(1));
    const Process_result refused =
      run_tool({"map", scratch / "other.off", "-o", scratch / "x.ply", "--data", scratch / "in.csv"});
    CHECK(refused.exit_code == 1);
    CHECK(is_one_line(refused.err));
    CHECK(contains(refused.err, "but the mesh has 42; give the data of this mesh"));
  }
}

TEST_CASE("register: features of one's own turn an ellipsoid of revolution about its axis", "[tool][data]")
{
  Scratch scratch;
  const Soup round = icosphere(4);
  const auto turned = [](const Point& p) { return Point(-p.y(), p.x(), p.z()); };
  const std::string body = write_off(scratch / "body.off", ellipsoid(1, 1, 1.5, 4)),
                    sphere = write_off(scratch / "sphere.off", round);
  tool::Vertex_data of_a = {{"x", {}}, {"y", {}}, {"z", {}}}, of_b = of_a;
  for(int k = 0; k < 3; ++k)
    for(const Point& p : round.points) {
      of_a[std::size_t(k)].values.push_back(300 * std::sin(5 * turned(p)[k] + k)); // another unit than B has
      of_b[std::size_t(k)].values.push_back(std::sin(5 * p[k] + k));
    }
  const std::string a = scratch / "a.csv", b = scratch / "b.csv";
  write_data(a, of_a);
  write_data(b, of_b);
  const auto run = [&](const std::vector<std::string>& options) {
    std::vector<std::string> command = {"register",
                                        body,
                                        body,
                                        "--sphere",
                                        sphere,
                                        sphere,
                                        "-o",
                                        scratch / "out.off",
                                        "--output-sphere",
                                        scratch / "registered.off",
                                        "--report",
                                        scratch / "r.json"};
    command.insert(command.end(), options.begin(), options.end());
    return run_tool(command);
  };
  const Process_result done = run({"--features", a, b, "--feature-weight", "20,20,10", "--curvature-weight", "0"});
  CAPTURE(done.out, done.err);
  REQUIRE(done.exit_code == 0);
  const Soup registered = read(scratch / "registered.off");
  for(std::size_t v = 0; v < round.points.size(); ++v)
    CHECK((registered.points[v] - turned(round.points[v])).squared_length() < 1e-3);
  CHECK(contains(text_of(scratch / "r.json"), "\"features\""));

  tool::Vertex_data with_labels = of_b, incomplete = of_b;
  with_labels[2] = {"parcel", std::vector<double>(round.points.size(), 1), true};
  incomplete[2].values[5] = missing;
  write_data(scratch / "two.csv", {of_b[0], of_b[1]});
  write_data(scratch / "incomplete.csv", incomplete);
  write_data(scratch / "lh.parcel.annot", {with_labels[2]});
  const auto refused = [&](const std::string& file, const std::vector<std::string>& options, int exit_code,
                           const std::string& word) {
    std::vector<std::string> all = {"--features", a, scratch / file};
    all.insert(all.end(), options.begin(), options.end());
    const Process_result result = run(all);
    CAPTURE(file, result.err);
    CHECK(result.exit_code == exit_code);
    CHECK(contains(result.err, word));
  };
  refused("two.csv", {}, 1, "has 2 columns");
  refused("incomplete.csv", {}, 1, "'z' has no value");
  refused("lh.parcel.annot", {}, 1, "has labels");
  refused("b.csv", {"--feature-weight", "1,2"}, 1, "2 weights");
  refused("b.csv", {"--feature-weight", "1,x"}, 2, "--feature-weight");
  refused("b.csv", {"--feature-weight", "-1"}, 2, "--feature-weight");

  Soup open = ellipsoid(1, 1, 1.5, 4);
  open.faces.erase(std::remove_if(open.faces.begin(), open.faces.end(),
                                  [&](const auto& face) { return open.points[std::size_t(face[0])].x() > 0.95; }),
                   open.faces.end());
  write_off(scratch / "open.off", open);
  const auto mend = [&] {
    return run_tool({"register", scratch / "open.off", body, "--prepare", "-o", scratch / "out.off", "--features", a, b,
                     "--feature-weight", "20", "--curvature-weight", "0", "--data", a, "--data-output",
                     scratch / "out.csv"});
  };
  const Process_result mended = mend();
  CAPTURE(mended.out, mended.err);
  REQUIRE(mended.exit_code == 0);
  const Soup on_b = read(scratch / "out.off");
  const tool::Vertex_data carried = tool::read_vertex_data(scratch / "out.csv", on_b.points.size());
  std::size_t added = 0;
  double sum = 0;
  for(std::size_t v = 0; v < on_b.points.size(); ++v) {
    const Point& p = on_b.points[v];
    added += std::isnan(carried[0].values[v]) ? 1 : 0;
    for(int k = 0; k < 3; ++k)
      if(const double value = carried[std::size_t(k)].values[v]; !std::isnan(value))
        sum += std::abs(value / 300 - std::sin(5 * (k < 2 ? p[k] : p[k] / 1.5) + k));
  }
  CHECK(added > 0);
  CHECK(sum / (3 * double(on_b.points.size())) < 0.05);
  of_a[0].values[std::size_t(open.faces[0][0])] = missing; // of the file
  write_data(a, of_a);
  CHECK(contains(mend().err, "no value at some vertices"));
}
