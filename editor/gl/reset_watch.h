#pragma once
// Whether the driver was reset and has dropped all that was made in a context.

namespace weftlight::gl {

/// Of the context that is current where it is made, and where it is asked.
class ResetWatch {
 public:
  ResetWatch();
  /// Never true of a driver that does not tell.
  bool is_lost() const;

 private:
  bool can_ask_;
};

}  // namespace weftlight::gl
