/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// A method of `CGAL::Spherical_parameterization::parameterize()`: a struct that has the options of the method as public
/// members with defaults, such as `Balanced{3}` or
/// \code
/// Saddle_point method;
/// method.splitting = Saddle_point::Splitting::GAUSS_SEIDEL;
/// \endcode If an option is out of range, `parameterize()` throws a `CGAL::Precondition_exception`, also with
/// `NDEBUG`.
///
/// This is a closed concept: the models are those below, and programs cannot add models through the public interface.
/// Inside the package a method M is a specialization of the class template `internal::Method_solver<M>` of
/// `internal/problem/Method_solver.h`. It checks the options, says whether weights are needed, and has one function,
/// `solve(backend, problem, effort, monitor)`, which returns a solution. `parameterize()` accepts every M for which
/// there is a specialization. This is internal and may change with every version; \ref CONTRIBUTING describes how to
/// add a method to the package.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Spherical_parameterization::Balanced`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Automatic`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Isometric`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Saddle_point`}
/// \cgalHasModelsEnd
class SphericalParameterizationMethod {
public:
  /// Default of the named parameter `accuracy`. Its meaning is that of the method.
  static constexpr double default_accuracy = unspecified;
  /// Default of the named parameter `number_of_iterations`.
  static constexpr std::size_t default_number_of_iterations = unspecified;
};
