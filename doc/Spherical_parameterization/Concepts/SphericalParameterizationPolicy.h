/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// Says where `CGAL::Spherical_parameterization::parameterize()` runs. A policy owns no data of a run: buffers and
/// programs are made inside the call, and released at its end.
///
/// This is a closed concept: programs cannot add models. Each model below has a backend in the package, with the same
/// operations and the same formulas, so the result does not depend on the policy, if floating-point numbers are rounded to nearest,
/// as they are unless a program changes it. A model is copyable, and several
/// threads may use the same model at the same time.
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Sequential_tag`: one core}
/// \cgalHasModel{`CGAL::Parallel_tag`: the threads of the caller's TBB arena; a static assertion fails where TBB is not linked}
/// \cgalHasModel{`CGAL::Spherical_parameterization::OpenCL_device`: an OpenCL command queue}
/// \cgalHasModelsEnd
class SphericalParameterizationPolicy {};
