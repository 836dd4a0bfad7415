#include "app/maps/MpiJob.h"

#include "core/Error.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>
#include <mpi.h>

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

}  // namespace asperity
