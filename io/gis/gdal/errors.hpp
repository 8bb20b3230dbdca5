// What GDAL says when something goes wrong.
#pragma once

#include <cpl_error.h>

#include <string>

namespace sandsim::gdal {

/// Collects GDAL's complaints while it lives, instead of letting GDAL print them.
class Complaints {
 public:
  Complaints() { CPLPushErrorHandlerEx(&Complaints::take, this); }
  ~Complaints() { CPLPopErrorHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  /// An error, not only a warning, was reported.
  bool failed() const { return failed_; }
  /// The first error, or the first warning if there is no error; `otherwise` if GDAL said nothing.
  std::string text(const std::string& otherwise) const { return first_.empty() ? otherwise : first_; }

 private:
  static void CPL_STDCALL take(CPLErr level, CPLErrorNum, const char* message) {
    auto& self = *static_cast<Complaints*>(CPLGetErrorHandlerUserData());
    const bool fails = level >= CE_Failure;
    if (self.first_.empty() || (fails && !self.failed_)) {
      self.first_ = message;
    }
    self.failed_ = self.failed_ || fails;
  }

  std::string first_;
  bool failed_ = false;
};

}  // namespace sandsim::gdal
