#include "app/maps/MapJob.h"

#include "core/AllowedCores.h"
#include "core/map/MapRow.h"

#include <chrono>
#include <deque>
#include <optional>
#include <thread>
#include <utility>

namespace asperity {

namespace {

// From rank 0: a row to compute, or that there are no more. To rank 0: at first for how many rows a
// rank asks at once, as a number below 0; then finished rows, each with its values, which asks for
// another one. Each time that a rank asks it gets one answer.
constexpr double kNoMore = -1.0;

/// A receive that waits would keep a core busy that computes.
constexpr std::chrono::milliseconds kPause(1);

void requireGoesOn(const Progress* progress) {
    if (progress != nullptr && progress->isCanceled()) {
        throw Canceled();
    }
}

int crewSize(int threads) { return threads > 0 ? threads : allowedCores(); }

std::vector<double> messageOf(const FinishedRow& made) {
    std::vector<double> numbers{static_cast<double>(made.row)};
    numbers.insert(numbers.end(), made.values.begin(), made.values.end());
    return numbers;
}

/// Needs both.
RowCrew::Compute rowsOf(const MapInstrument& instrument, const MapPlan& plan) {
    return [&](int row, const CancelCheck& check) { return mapRow(instrument, plan, row, check); };
}

/// What rank 0 hands out and keeps.
class RowLedger {
public:
    RowLedger(const MpiJob& job, MapPart& part, Progress* progress)
        : job_(job), part_(part), progress_(progress), silent_(job.size() - 1) {
        for (int row = 0; row < part.rows(); ++row) {
            if (!part.has(row)) {
                missing_.push_back(row);
            }
        }
    }

    /// The next row for a rank; none: all are handed out.
    [[nodiscard]] std::optional<int> next() {
        if (missing_.empty()) {
            return std::nullopt;
        }
        const int row = missing_.front();
        missing_.pop_front();
        return row;
    }
    void keep(int row, const std::vector<double>& values) {
        part_.keep(row, values);
        reportTo(progress_, static_cast<double>(part_.count()) / part_.rows());
    }
    /// Takes what a rank says, and answers.
    void answer(const MpiJob::Message& message) {
        const double first = message.numbers.at(0);
        if (first < 0.0) {
            --silent_;
            for (int ask = 0; ask < static_cast<int>(-first); ++ask) {
                ++asked_;
                answerOnce(message.rank);
            }
        } else {
            keep(static_cast<int>(first), {message.numbers.begin() + 1, message.numbers.end()});
            answerOnce(message.rank);
        }
    }
    /// Whether each rank knows that there are no more rows.
    [[nodiscard]] bool isOver() const { return silent_ == 0 && asked_ == 0; }

private:
    void answerOnce(int rank) {
        const std::optional<int> row = next();
        asked_ -= row ? 0 : 1;
        job_.send(rank, {row ? static_cast<double>(*row) : kNoMore});
    }

    const MpiJob& job_;
    MapPart& part_;
    Progress* progress_;
    int silent_;     ///< ranks that have asked for nothing yet
    int asked_ = 0;  ///< what ranks ask for without the answer that there are no more
    std::deque<int> missing_;
};

}  // namespace

void leadRows(const MpiJob& job, MapPart& part, RowCrew::Compute compute, int threads,
              Progress* progress) {
    RowLedger ledger(job, part, progress);
    RowCrew crew(crewSize(threads), std::move(compute));
    const auto giveOne = [&] {
        if (const std::optional<int> row = ledger.next()) {
            crew.give(*row);
        }
    };
    for (int i = 0; i < crewSize(threads); ++i) {
        giveOne();
    }
    while (crew.open() > 0 || !ledger.isOver()) {
        requireGoesOn(progress);
        for (const FinishedRow& made : crew.take()) {
            ledger.keep(made.row, made.values);
            giveOne();
        }
        if (const auto message = job.receive()) {
            ledger.answer(*message);
        } else {
            std::this_thread::sleep_for(kPause);
        }
    }
}

void followRows(const MpiJob& job, RowCrew::Compute compute, int threads,
                const Progress* progress) {
    RowCrew crew(crewSize(threads), std::move(compute));
    int asked = crewSize(threads);
    job.send(0, {static_cast<double>(-asked)});
    while (asked > 0) {
        requireGoesOn(progress);
        for (const FinishedRow& made : crew.take()) {
            job.send(0, messageOf(made));
        }
        if (const auto message = job.receive()) {
            const double row = message->numbers.at(0);
            if (row == kNoMore) {
                --asked;
            } else {
                crew.give(static_cast<int>(row));
            }
        } else {
            std::this_thread::sleep_for(kPause);
        }
    }
}

void leadMap(const MpiJob& job, const Scene& scene, const MapPlan& plan, MapPart& part, int threads,
             Progress* progress) {
    const MapInstrument instrument(scene, plan.truth);
    leadRows(job, part, rowsOf(instrument, plan), threads, progress);
}

void followMap(const MpiJob& job, const Scene& scene, const MapPlan& plan, int threads,
               const Progress* progress) {
    const MapInstrument instrument(scene, plan.truth);
    followRows(job, rowsOf(instrument, plan), threads, progress);
}

}  // namespace asperity
