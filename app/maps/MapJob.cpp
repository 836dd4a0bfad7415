#include "app/maps/MapJob.h"

#include "core/Error.h"
#include "core/map/MapPlan.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <mpi.h>
#include <utility>

namespace asperity {

namespace {

constexpr int kTag = 1;

/// MPI_Init of a lone process takes 0.36 s. Open MPI, PMIx, and Hydra of MPICH set these.
bool isUnderLauncher() {
    constexpr std::array kNames{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
    return std::ranges::any_of(kNames,
                               [](const char* name) { return std::getenv(name) != nullptr; });
}

}  // namespace

MpiJob::MpiJob() : exceptions_(std::uncaught_exceptions()) {
    if (isUnderLauncher()) {
        int given = MPI_THREAD_SINGLE;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
        isInitialized_ = true;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
    }
}

MpiJob::~MpiJob() {
    if (isInitialized_ && std::uncaught_exceptions() == exceptions_) {
        MPI_Finalize();
    }
}

void MpiJob::requireSame(const std::string& text, const std::string& what) const {
    if (isAlone()) {
        return;
    }
    std::string first = text;
    auto length = static_cast<int>(first.size());
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    first.resize(static_cast<std::size_t>(length));
    MPI_Bcast(first.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
    if (first != text) {
        throw Error(what + " of rank " + std::to_string(rank_) +
                    " is another one than that of rank 0: files or programs differ");
    }
}

void MpiJob::send(int rank, const std::vector<double>& numbers) const {
    MPI_Send(numbers.data(), static_cast<int>(numbers.size()), MPI_DOUBLE, rank, kTag,
             MPI_COMM_WORLD);
}

std::optional<MpiJob::Message> MpiJob::receive() const {
    int isThere = 0;
    MPI_Status status;
    MPI_Iprobe(MPI_ANY_SOURCE, kTag, MPI_COMM_WORLD, &isThere, &status);
    if (isThere == 0) {
        return std::nullopt;
    }
    int count = 0;
    MPI_Get_count(&status, MPI_DOUBLE, &count);
    Message message{.rank = status.MPI_SOURCE,
                    .numbers = std::vector<double>(static_cast<std::size_t>(count))};
    MPI_Recv(message.numbers.data(), count, MPI_DOUBLE, status.MPI_SOURCE, kTag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
}

void MpiJob::abort(int exitCode) const noexcept {
    MPI_Abort(MPI_COMM_WORLD, exitCode);
    std::_Exit(exitCode);
}

MapWorkers::MapWorkers(int threads, Compute compute) : compute_(std::move(compute)) {
    for (int i = 0; i < threads; ++i) {
        threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
}

MapWorkers::~MapWorkers() { ended_ = true; }

void MapWorkers::give(int row) {
    ++open_;
    const std::scoped_lock lock(mutex_);
    wanted_.push_back(row);
    waiting_.notify_one();
}

std::vector<FinishedRow> MapWorkers::take() {
    const std::scoped_lock lock(mutex_);
    if (error_) {
        std::rethrow_exception(error_);
    }
    open_ -= finished_.size();
    return std::exchange(finished_, {});
}

void MapWorkers::work(const std::stop_token& stop) {
    const CancelCheck check(nullptr, ended_, nullptr);
    for (;;) {
        std::unique_lock lock(mutex_);
        if (!waiting_.wait(lock, stop, [this] { return !wanted_.empty(); })) {
            return;
        }
        const int row = wanted_.front();
        wanted_.pop_front();
        lock.unlock();
        try {
            FinishedRow made{.row = row, .values = compute_(row, check)};
            lock.lock();
            finished_.push_back(std::move(made));
        } catch (...) {
            lock.lock();
            error_ = std::current_exception();
            return;
        }
    }
}

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
MapWorkers::Compute rowsOf(const MapInstrument& instrument, const MapPlan& plan) {
    return [&](int row, const CancelCheck& check) { return mapRow(instrument, plan, row, check); };
}

/// Rows that rank 0 assigns and keeps.
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

    /// The next row for a rank; none: all are assigned.
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
    /// Returns whether each rank knows that there are no more rows.
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
    int asked_ = 0;  ///< requests of ranks without the answer that there are no more
    std::deque<int> missing_;
};

}  // namespace

void leadRows(const MpiJob& job, MapPart& part, MapWorkers::Compute compute, int threads,
              Progress* progress) {
    RowLedger ledger(job, part, progress);
    MapWorkers crew(crewSize(threads), std::move(compute));
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

void followRows(const MpiJob& job, MapWorkers::Compute compute, int threads,
                const Progress* progress) {
    MapWorkers crew(crewSize(threads), std::move(compute));
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

void computeMap(const Scene& scene, const MapPlan& plan, MapPart& part, int threads,
                Progress* progress) {
    std::vector<int> missing;
    for (int row = 0; row < part.rows(); ++row) {
        if (!part.has(row)) {
            missing.push_back(row);
        }
    }
    if (missing.empty()) {
        return;
    }
    const MapInstrument instrument(scene, plan.truth);
    ProgressPart rest(progress, static_cast<double>(part.count()) / part.rows(), 1.0);
    shareOut(
        static_cast<int>(missing.size()), &rest,
        [&](int index, const CancelCheck& check) {
            const int row = missing[static_cast<std::size_t>(index)];
            part.keep(row, mapRow(instrument, plan, row, check));
        },
        threads);
}

}  // namespace asperity
