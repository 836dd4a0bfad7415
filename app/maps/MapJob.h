#pragma once

#include "app/maps/MapPart.h"
#include "app/maps/MpiJob.h"
#include "app/maps/RowCrew.h"
#include "core/Progress.h"
#include "core/map/MapPlan.h"

namespace asperity {

/// The part of rank 0: keeps the rows that the part lacks, computed by all ranks of a job, and
/// computes as well. Each rank asks for another row as soon as it has finished one: a slow machine
/// gets fewer.
/// @param threads of this rank; 0: as many as it may use cores @param progress may be null
/// @throw Canceled, Error; the rows finished until then are kept
void leadRows(const MpiJob& job, MapPart& part, RowCrew::Compute compute, int threads,
              Progress* progress);

/// The part of the other ranks: computes rows that rank 0 hands out, until there are no more.
/// @param progress is asked for cancellation alone; may be null @throw Canceled, Error
void followRows(const MpiJob& job, RowCrew::Compute compute, int threads, const Progress* progress);

/// leadRows() of a map.
void leadMap(const MpiJob& job, const Scene& scene, const MapPlan& plan, MapPart& part, int threads,
             Progress* progress);

/// followRows() of a map.
void followMap(const MpiJob& job, const Scene& scene, const MapPlan& plan, int threads,
               const Progress* progress);

}  // namespace asperity
