/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// The spring constant of every edge: what the named parameter `edge_weight_map` takes.
///
/// \cgalRefines{`boost::ReadablePropertyMap`}
///
/// A weight belongs to an edge and not to a halfedge, since a spring pulls both ends alike: weights are symmetric. All have
/// to be positive and finite; otherwise the result is `BAD_WEIGHT`. They may be of any unit, and differ by any factor,
/// though no solver can do better than doubles.
///
/// The map is read once for every edge, while the mesh is read: by several threads at once, unless the policy is
/// `CGAL::Sequential_tag`.
///
/// Every readable map from edges to numbers is a model, say a `CGAL::Surface_mesh::Property_map<Edge_index, double>`.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Spherical_parameterization::Barycentric_weight_map`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Conformal_weight_map`}
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
