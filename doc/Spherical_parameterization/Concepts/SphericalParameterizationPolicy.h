/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// Where `CGAL::Spherical_parameterization::parameterize()` runs: a value that says on what, and owns nothing of a run. The
/// buffers and programs of a run are made inside of the call and gone after it.
///
/// The set of models is closed: each has a backend in the package, with the same verbs over the same formulas, so that a
/// result does not depend on the policy. A model is copyable, and any number of threads may use one at once.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Sequential_tag`: one core}
/// \cgalHasModel{`CGAL::Parallel_tag`: the threads of the caller's TBB arena; a static assertion fails where TBB is not linked}
/// \cgalHasModel{`CGAL::Spherical_parameterization::OpenCL_device`: an OpenCL command queue}
/// \cgalHasModelsEnd
class SphericalParameterizationPolicy {};
