/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// A map to the sphere: a point of the unit sphere for every vertex.
///
/// \cgalRefines{`boost::WritablePropertyMap` for `CGAL::Spherical_parameterization::parameterize()`; also
/// `boost::ReadablePropertyMap` where vertices are fixed, and for all functions that take a map as input}
///
/// Its values have three coordinates in floating point or exact numbers: `CGAL::Point_3` and `CGAL::Vector_3` of any
/// kernel, `std::array<double, 3>`, or an Eigen vector. Other values, such as `Point_2` or integers, fail a static
/// assertion. The certificate is about the values that the map stores: for values of single precision, positions are
/// rounded to floats first, and the rounded positions are certified.
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
