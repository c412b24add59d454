/// \ingroup PkgSphericalParameterizationConcepts
/// \cgalConcept
/// How `CGAL::Spherical_parameterization::segmentation_from_area_stretch()` cuts: a tag that carries the options of its method
/// as public members with defaults.
///
/// The set of models is closed.
///
/// \cgalRefines{`CGAL::Spherical_parameterization::Segment_limits`\, from which it is derived}
///
/// \cgalHasModelsBegin
/// \cgalHasModel{`CGAL::Spherical_parameterization::Majority_vote`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Girth_profiles`}
/// \cgalHasModel{`CGAL::Spherical_parameterization::Region_growing`}
/// \cgalHasModelsEnd
class SphericalSegmentationMethod {};
