#pragma once
// The heap of a program that does one job and then ends.

namespace handlebody::cli {

//! A run takes and gives back much memory in a short time. What it gives back stays with the program: the
//! system would clear every page anew.
void keepFreedMemory();

//! The heap on huge pages (after keepFreedMemory): to ask the system for it by 4 KiB took a fifth of a run.
//! What is reserved is no memory before it is used; where it cannot be reserved the heap is one like any
//! other.
void reserveHeap();

}  // namespace handlebody::cli
