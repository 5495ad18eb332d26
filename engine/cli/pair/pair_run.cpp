#include <graze/engine/cli/output/progress.h>
#include <graze/engine/cli/pair/answer_file.h>
#include <graze/engine/cli/pair/pair_job.h>
#include <graze/engine/cli/pair/pair_report.h>
#include <graze/engine/cli/pair/pair_run.h>

#include <memory>

namespace graze::cli {
namespace {

/// Answers as they come, a row each.
ExitCode report_answers(const PairJob& job, const PairOptions& options, Output& output) {
  const PairReportSettings settings = {
      .query = job.query, .is_listing = options.is_listing, .is_checked = job.fcl != nullptr};
  const std::unique_ptr<PairReport> report =
      options.is_json ? make_json_report(output, settings) : make_table_report(output, settings);
  Progress progress("poses:", job.poses_b->size(), {.is_forced = options.has_progress});

  bool is_graze_wrong = false;
  try {
    report->begin();
    for (std::size_t i = 0; i < job.poses_b->size(); ++i) {
      PoseAnswer answer = ask(job, job.poses_b->at(i), job.threads);
      answer.pose = i;
      is_graze_wrong |= answer.fcl && answer.fcl->graze_wrong > 0;
      report->add(answer);
      progress.update(i + 1);
    }
    report->end();
  } catch (const OutputClosed&) {
    // The reader has all that it wanted, but a wrong answer stays one.
  }
  return is_graze_wrong ? ExitCode::GrazeWrong : ExitCode::Answered;
}

/// Answers in a file, and what they come to.
ExitCode file_answers(const PairJob& job, const PairOptions& options, Output& output) {
  Progress progress("poses:", job.poses_b->size(),
                    {.is_forced = options.has_progress, .has_rows = false});
  const AnswerTotals totals = write_answers(
      job, *options.output, [&](std::size_t done, std::size_t) { progress.update(done); });
  try {
    output.write(options.is_json ? to_json(totals, *options.output)
                                 : to_text(totals, *options.output));
  } catch (const OutputClosed&) {
    // The file stands, whoever reads of it.
  }
  return ExitCode::Answered;
}

}  // namespace

ExitCode run_pair(const PairOptions& options, Output& output) {
  const PairJob job = read_pair_job(options);
  return options.output ? file_answers(job, options, output) : report_answers(job, options, output);
}

}  // namespace graze::cli
