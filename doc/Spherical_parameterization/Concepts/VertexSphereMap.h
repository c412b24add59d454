/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// Where a map to the sphere is kept: a point of the unit sphere for every vertex.
///
/// \cgalRefines{`boost::WritablePropertyMap` for `CGAL::Spherical_parameterization::parameterize()`; also
/// `boost::ReadablePropertyMap` where vertices are fixed, and for all functions that take a map as input}
///
/// Nothing is assumed of the type of its values but that they have coordinates: `CGAL::Point_3` and `CGAL::Vector_3` of a kernel
/// with a number type that doubles convert to without loss, `std::array<double, 3>`, or an Eigen vector. The
/// coordinates written are those that were certified: a value type of single precision rounds them, and the certificate
/// does not hold for what it has become.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Surface_mesh::Property_map<Vertex_index\, Point_3>`}
/// \cgalHasModel{the vertex point map of a mesh\, which is then moved to the sphere}
/// \cgalHasModel{`boost::associative_property_map<std::map<vertex_descriptor\, Point_3>>`}
/// \cgalHasModelsEnd
class VertexSphereMap {
public:
  /// `boost::graph_traits<TriangleMesh>::%vertex_descriptor`
  typedef unspecified_type key_type;
  /// Constructible as `value_type{x, y, z}` from three doubles; where the map is read, with `x()`, `y()`, `z()` or `operator[]`.
  typedef unspecified_type value_type;
};
