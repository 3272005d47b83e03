#include "loom/weaving.h"

#include <algorithm>

namespace weftlight::loom {
namespace {

Section bounded(const Section& s, int picks) {
  const Section in{std::clamp(s.first, 0, picks), std::clamp(s.end, 0, picks)};
  return in.first < in.end ? in : Section{0, picks};
}

/// Raises the shafts of the next pick.
Answer raised(const Weaving& w, Place place) {
  const std::optional<uint32_t> shafts = raised_shafts(w.draft, w.lifts, place.next_pick);
  if (!shafts)
    return {place,
            {},
            "the line can name " + std::to_string(kMaxLoomShafts) + " shafts, and the draft has " +
                std::to_string(w.draft.shafts)};
  place.waiting = true;
  return {place, raise_command(w.protocol, *shafts), {}};
}

}  // namespace

Place stepped(Place place, const Section& section, int picks) {
  const Section s = bounded(section, picks);
  if (s.first >= s.end) return place;
  place = jumped(place, s, picks, place.next_pick);
  const int step = place.weaving ? 1 : -1, count = s.end - s.first;
  place.next_pick = s.first + (place.next_pick - s.first + step + count) % count;
  place.woven += step;
  return place;
}

Place jumped(Place place, const Section& section, int picks, int pick) {
  const Section s = bounded(section, picks);
  place.next_pick = s.first < s.end ? std::clamp(pick, s.first, s.end - 1) : 0;
  place.waiting = false;
  return place;
}

Answer answer(const Weaving& w, const Place& place, const LoomReport& report) {
  switch (report.kind) {
    case LoomReport::kPickWanted:
      // The pick whose shafts were up has been woven; the first one of all has not.
      return raised(w, place.waiting ? stepped(place, w.section, w.lifts.rows()) : place);
    case LoomReport::kDirection: {
      Place turned = place;
      turned.weaving = report.on;
      return {turned, {}, {}};
    }
    case LoomReport::kShaftsRaised: {
      const std::optional<uint32_t> wanted = raised_shafts(w.draft, w.lifts, place.next_pick);
      const bool other = place.waiting && wanted && *wanted != report.shafts;
      return {place, {}, other ? "the loom has raised other shafts than were sent" : ""};
    }
    case LoomReport::kMotion:
      return {place, {}, {}};
    case LoomReport::kUnknown:
      break;
  }
  return {place, {}, "the loom said something that is not known: " + report.text};
}

Answer on_connected(const Weaving& w, const Place& place) {
  Answer first = place.waiting ? raised(w, place) : Answer{place, {}, {}};
  first.send.insert(0, direction_command(w.protocol, place.weaving));
  return first;
}

Answer step_by_hand(const Weaving& w, const Place& place, bool forwards) {
  Place turned = place;
  turned.weaving = forwards;
  Answer next = raised(w, place.waiting || !forwards ? stepped(turned, w.section, w.lifts.rows()) : turned);
  if (turned.weaving != place.weaving) next.send.insert(0, direction_command(w.protocol, forwards));
  return next;
}

}  // namespace weftlight::loom
