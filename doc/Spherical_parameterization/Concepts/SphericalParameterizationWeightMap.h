/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// Spring constants of the edges: the type of the named parameter `edge_weight_map`.
///
/// \cgalRefines{`boost::ReadablePropertyMap`}
///
/// Weights are symmetric: they belong to edges, not to halfedges. All must be positive and finite; otherwise the result
/// is `BAD_WEIGHT`, or `DEGENERATE_FACE` at a face of (almost) no area. Their unit is arbitrary. Large ratios between weights cost iterations and accuracy.
///
/// The map is read once for every edge, while the mesh is read, by several threads at the same time unless the policy
/// is `CGAL::Sequential_tag`.
///
/// Every readable map from edges to numbers is a model, such as `CGAL::Surface_mesh::Property_map<Edge_index, double>`.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Spherical_parameterization::Barycentric_weight_map`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Clamped_weight_map`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Mean_value_weight_map`}
/// \cgalHasModelsEnd
class SphericalParameterizationWeightMap {
public:
  /// `boost::graph_traits<TriangleMesh>::%edge_descriptor`
  typedef unspecified_type key_type;
  /// Convertible to `double`.
  typedef unspecified_type value_type;
};

/// The weight of an edge: positive and finite.
/// \relates SphericalParameterizationWeightMap
/// \param map   of weights
/// \param edge  of the mesh
/// \return a number convertible to `double`
value_type get(const SphericalParameterizationWeightMap& map, const key_type& edge);
