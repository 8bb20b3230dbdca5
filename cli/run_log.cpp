// The only file that includes spdlog: it takes seconds to compile.
#include "cli/run_log.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/spdlog.h>

#include "solver/errors.hpp"

namespace sandsim::cli {

class RunLog::Logger : public spdlog::logger {
 public:
  Logger(const std::filesystem::path& path, bool append)
      : spdlog::logger("sandsim", std::make_shared<spdlog::sinks::basic_file_sink_st>(path.string(), !append)) {}
};

RunLog::RunLog(const std::filesystem::path& path, bool append) {
  try {
    logger_ = std::make_unique<Logger>(path, append);
  } catch (const spdlog::spdlog_ex& error) {
    throw OutputError(path.string() + ": cannot be written: " + error.what());
  }
  logger_->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
  logger_->flush_on(spdlog::level::info);
  logger_->set_error_handler([](const std::string&) {});
}

RunLog::~RunLog() = default;

// The messages are arguments, not formats: they may hold braces.
void RunLog::info(const std::string& message) {
  logger_->info("{}", message);
}
void RunLog::warning(const std::string& message) {
  logger_->warn("{}", message);
}
void RunLog::error(const std::string& message) {
  logger_->error("{}", message);
}

}  // namespace sandsim::cli
