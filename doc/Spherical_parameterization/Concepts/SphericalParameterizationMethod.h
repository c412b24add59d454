/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// How `CGAL::Spherical_parameterization::parameterize()` computes a map: a tag that carries the options of its method as
/// public members with defaults, so that `Balanced{3}` or
/// \code
/// Saddle_point method;
/// method.splitting = Saddle_point::Splitting::GAUSS_SEIDEL;
/// \endcode
/// is all there is to say. Options out of range are misuse: a precondition fails.
///
/// The set of models is closed, as that of the policies.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Spherical_parameterization::Balanced`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Automatic`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Isometric`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Saddle_point`}
/// \cgalHasModelsEnd
class SphericalParameterizationMethod {
public:
  /// What the named parameter `accuracy` is where it is not given. Its unit is that of the method.
  static constexpr double default_accuracy = unspecified;
  /// What the named parameter `number_of_iterations` is where it is not given.
  static constexpr std::size_t default_number_of_iterations = unspecified;
};
