/* sweep_mpi.c -- the ranks of a parallel job: with MPI (-DSWEEP_MPI) or one alone.
 * template: templates/sweep/sweep_mpi.c.  SPDX-License-Identifier: MIT-0
 *
 * Work is handed out by one counter in the memory of rank 0, which every rank adds 1 to.  Some transports serve such a
 * request only while rank 0 is inside MPI: there the main thread computes nothing and enters MPI every millisecond. */
#include "sweep.h"

#ifdef SWEEP_MPI
#include <mpi.h>

static MPI_Win window;
static int64_t *counter;

void sweep_ranks_open(int *argc, char ***argv, int *rank, int *ranks)
{
  int level;

  MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &level); /* one thread alone calls MPI */
  MPI_Comm_rank(MPI_COMM_WORLD, rank);
  MPI_Comm_size(MPI_COMM_WORLD, ranks);
  MPI_Win_allocate(*rank == 0 ? (MPI_Aint)sizeof *counter : 0, (int)sizeof *counter, MPI_INFO_NULL, MPI_COMM_WORLD,
    &counter, &window);
  if (*rank == 0) {
    MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window);
    *counter = 0;
    MPI_Win_unlock(0, window);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Win_lock_all(0, window);
}

uint64_t sweep_ranks_next(void)
{
  const int64_t one = 1;
  int64_t mine = 0;

  MPI_Fetch_and_op(&one, &mine, MPI_INT64_T, 0, 0, MPI_SUM, window);
  MPI_Win_flush(0, window);
  return (uint64_t)mine;
}

void sweep_ranks_attend(void)
{
  int flag;

  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &flag, MPI_STATUS_IGNORE);
}

void sweep_ranks_wait(void) { MPI_Barrier(MPI_COMM_WORLD); }

int sweep_ranks_tell(int value)
{
  MPI_Bcast(&value, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return value;
}

void sweep_ranks_close(void)
{
  MPI_Win_unlock_all(window);
  MPI_Win_free(&window);
  MPI_Finalize();
}

void sweep_ranks_abort(int status) { MPI_Abort(MPI_COMM_WORLD, status); }

const char *sweep_ranks_about(void) { return "MPI"; }

#else

static uint64_t counter;

void sweep_ranks_open(int *argc, char ***argv, int *rank, int *ranks)
{
  (void)argc;
  (void)argv;
  *rank = 0;
  *ranks = 1;
}

uint64_t sweep_ranks_next(void) { return counter++; }
void sweep_ranks_attend(void) {}
void sweep_ranks_wait(void) {}
int sweep_ranks_tell(int value) { return value; }
void sweep_ranks_close(void) {}
void sweep_ranks_abort(int status) { (void)status; }
const char *sweep_ranks_about(void) { return "no MPI"; }

#endif
