/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// Where `CGAL::Spherical_parameterization::parameterize()` runs. A policy owns nothing of a run: buffers and programs are
/// made inside of the call, and released at its end.
///
/// This is a closed enumeration rather than an open concept: each model below has a backend in the package, with the same
/// operations over the same formulas, so that a result does not depend on the policy. Programs cannot add one. A model is
/// copyable, and any number of threads may use one at once.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Sequential_tag`: one core}
/// \cgalHasModel{`CGAL::Parallel_tag`: the threads of the caller's TBB arena; a static assertion fails where TBB is not linked}
/// \cgalHasModel{`CGAL::Spherical_parameterization::OpenCL_device`: an OpenCL command queue}
/// \cgalHasModelsEnd
class SphericalParameterizationPolicy {};
