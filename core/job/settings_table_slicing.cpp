#include "core/job/settings_table_rows.h"

namespace slipstick {
namespace {

constexpr std::string_view kPlacements[] = {"roots", "sliding", "projection", "laplacian",
                                            "midpoints"};
constexpr std::string_view kSimplifications[] = {"fewest", "vsa", "greedy", "none"};
constexpr std::string_view kCandidates[] = {"three", "one"};
constexpr std::string_view kAmbiguities[] = {"solid", "void"};
constexpr std::string_view kCertifications[] = {"strict", "report", "off"};

constexpr Setting kRows[] = {
    {"layer_height", SettingGroup::kSlicing, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.slicing.layer_height); }, 0.02, 1.5},
     "Thickness of layers. A quarter to three quarters of the nozzle: thin for smooth slopes, "
     "thick for speed."},
    {"first_layer_height", SettingGroup::kSlicing, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.slicing.first_layer_height); }, 0.02,
                   1.5},
     "Thickness of the first layer. Half the nozzle forgives an uneven bed."},
    {"sampling", SettingGroup::kSlicing, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.slicing.sampling); }, 0.002, 2},
     "Distance of samples, the paper's r'. Below the thinnest wall or gap divided by 1.73; smaller "
     "costs time by its square."},
    {"alpha", SettingGroup::kSlicing, "",
     IntegerSetting{[](auto& s) -> decltype(auto) { return (s.slicing.alpha); }, 1, 1000},
     "Clustering ratio of the paper: one proxy for so many contour edges. 10; lower keeps more "
     "detail at equal tolerance."},
    {"tolerance", SettingGroup::kSlicing, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.slicing.tolerance); }, 0, 1},
     "Farthest that simplified contours stray from placed ones. A twentieth of the nozzle is not "
     "seen."},
    {"place", SettingGroup::kSlicing, "",
     ChoiceSetting{
         kPlacements,
         [](const PrintSettings& s) { return static_cast<std::size_t>(s.slicing.place); },
         [](PrintSettings& s, std::size_t i) { s.slicing.place = static_cast<Placement>(i); }},
     "Where vertices sit on their sticks. roots is the solid's very surface; the others are the "
     "paper's, for comparison."},
    {"simplify", SettingGroup::kSlicing, "",
     ChoiceSetting{
         kSimplifications,
         [](const PrintSettings& s) { return static_cast<std::size_t>(s.slicing.simplify); },
         [](PrintSettings& s, std::size_t i) {
           s.slicing.simplify = static_cast<Simplification>(i);
         }},
     "How contours get fewer edges. fewest finds the fewest that the tolerance allows; vsa is the "
     "paper's; greedy takes each edge as far as it goes; none shows the contours as placed."},
    {"candidates", SettingGroup::kSlicing, "",
     ChoiceSetting{
         kCandidates,
         [](const PrintSettings& s) { return static_cast<std::size_t>(s.slicing.candidates); },
         [](PrintSettings& s, std::size_t i) {
           s.slicing.candidates = static_cast<Candidates>(i);
         }},
     "Where fewest may put a vertex. three tries both ends of what the tolerance leaves of a "
     "stick, "
     "one keeps to the placed contour: quicker, with about half as many edges again."},
    {"ambiguity", SettingGroup::kSlicing, "",
     ChoiceSetting{
         kAmbiguities,
         [](const PrintSettings& s) { return static_cast<std::size_t>(s.slicing.ambiguity); },
         [](PrintSettings& s, std::size_t i) { s.slicing.ambiguity = static_cast<Ambiguity>(i); }},
     "Whether samples that touch only across a square's diagonal hang together through the solid "
     "or through the void. solid keeps thin walls whole."},
    {"regularize", SettingGroup::kSlicing, "mm",
     NumberSetting{[](auto& s) -> decltype(auto) { return (s.slicing.regularize); }, 0, 5},
     "Radius of a ball that opens and then closes the solid in space: what it cannot enter inside "
     "goes, what it cannot enter outside is filled. 0 leaves the solid as it is; 1.8 samplings "
     "make features large enough to be told."},
    {"certify", SettingGroup::kSlicing, "",
     ChoiceSetting{
         kCertifications,
         [](const PrintSettings& s) { return static_cast<std::size_t>(s.slicing.certify); },
         [](PrintSettings& s, std::size_t i) {
           s.slicing.certify = static_cast<Certification>(i);
         }},
     "Whether slices are proved to have the topology of the solid, and nothing to hide between two "
     "of them. strict ends the job where that fails, report counts, off saves the time."},
};

}  // namespace

std::span<const Setting> slicing_rows() {
  return kRows;
}

}  // namespace slipstick
