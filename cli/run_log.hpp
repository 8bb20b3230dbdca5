// log.txt: what a run did and when, one line each.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace sandsim::cli {

/// Every line is in the file before the call returns, so that it survives a kill. Lines that cannot be written are
/// dropped: on a full disk the series reports the error, and a log is not worth a run.
class RunLog {
 public:
  /// Throws OutputError if the file cannot be opened.
  RunLog(const std::filesystem::path& path, bool append);
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  void info(const std::string& message);
  void warning(const std::string& message);
  void error(const std::string& message);

 private:
  class Logger;
  std::unique_ptr<Logger> logger_;
};

}  // namespace sandsim::cli
