#include "solver/backends/cuda/cuda.hpp"
#include "solver/backends/cuda/cuda_machine.cuh"

namespace sandsim::cuda {
namespace {

/// First driver that repeats graphs by itself: CUDA 12.4.
constexpr int driver_with_loops = 12040;

}  // namespace

std::shared_ptr<CudaMachine> make_machine();
std::shared_ptr<CudaMachine> make_machine() {
  return std::make_shared<CudaMachine>();
}

CudaMachine::CudaMachine() {
  const CudaSurvey survey = survey_cuda();
  if (!survey.problem.empty()) {
    throw DeviceError(survey.problem);
  }
  name_ = "cuda (" + survey.name + ")";
  processors_ = survey.processors;
  drivers_loops_ = survey.driver >= driver_with_loops;
  check(cudaSetDevice(0), "be chosen");
  int bytes = 0;
  check(cudaDeviceGetAttribute(&bytes, cudaDevAttrMaxSharedMemoryPerBlockOptin, 0), "tell its shared memory");
  shared_bytes_a_block_ = static_cast<std::size_t>(bytes);
  check(cudaStreamCreateWithFlags(&stream_, cudaStreamNonBlocking), "make a stream");
  check(cudaStreamCreateWithFlags(&copies_, cudaStreamNonBlocking), "make a stream for copies");
  check(cudaEventCreateWithFlags(&made_, cudaEventDisableTiming), "make an event");
}

CudaMachine::~CudaMachine() {
  cudaEventDestroy(made_);
  cudaStreamDestroy(copies_);
  cudaStreamDestroy(stream_);
}

CudaMachine::Loop::~Loop() {
  if (executable_ != nullptr) {
    cudaGraphExecDestroy(executable_);
  }
  if (graph_ != nullptr) {
    cudaGraphDestroy(graph_);
  }
}

std::size_t CudaMachine::free_bytes() const {
  std::size_t free = 0, total = 0;
  check(cudaMemGetInfo(&free, &total), "tell its free memory");
  return free;
}

void* CudaMachine::allocate(std::size_t bytes) {
  void* memory = nullptr;
  if (bytes == 0) {
    return memory;
  }
  const cudaError_t status = cudaMalloc(&memory, bytes);
  if (status == cudaErrorMemoryAllocation) {
    cudaGetLastError();  // forget it: the device is as it was
    throw DeviceError(name_ + " has " + std::to_string(free_bytes() >> 20) + " MiB of memory free and " +
                      std::to_string(bytes >> 20) + " MiB more are needed. Use fewer cells, or --device cpu?");
  }
  check(status, "allocate memory");
  check(cudaMemsetAsync(memory, 0, bytes, stream_), "clear memory");
  return memory;
}

void* CudaMachine::allocate_on_host(std::size_t bytes) {
  void* memory = nullptr;
  if (bytes > 0) {
    check(cudaMallocHost(&memory, bytes), "reserve memory of the host");
  }
  return memory;
}

int CudaMachine::read(const int* value) {
  int copy = 0;
  download(&copy, value, 1);
  return copy;
}

cudaGraph_t CudaMachine::begin_loop(Loop& loop) {
  check(cudaGraphCreate(&loop.graph_, 0), "make a graph");
  cudaGraphConditionalHandle handle = 0;
  cudaGraphNodeParams parameters = {};
  parameters.type = cudaGraphNodeTypeConditional;
  parameters.conditional.type = cudaGraphCondTypeWhile;
  parameters.conditional.size = 1;
  cudaGraphNode_t node = nullptr;
  cudaError_t status = cudaGraphConditionalHandleCreate(&handle, loop.graph_, 1, cudaGraphCondAssignDefault);
  if (status == cudaSuccess) {
    parameters.conditional.handle = handle;
    status = cudaGraphAddNode(&node, loop.graph_, nullptr, nullptr, 0, &parameters);
  }
  if (status != cudaSuccess) {
    cudaGetLastError();
    cudaGraphDestroy(std::exchange(loop.graph_, nullptr));
    return nullptr;
  }
  recording_ = handle;
  return parameters.conditional.phGraph_out[0];
}

bool CudaMachine::end_loop(Loop& loop) {
  recording_ = 0;
  cudaGraph_t turn = nullptr;
  check(cudaStreamEndCapture(stream_, &turn), "record a step");
  if (cudaGraphInstantiate(&loop.executable_, loop.graph_, 0) != cudaSuccess) {
    cudaGetLastError();
    loop.executable_ = nullptr;
    cudaGraphDestroy(std::exchange(loop.graph_, nullptr));
    return false;
  }
  loop.repeats_itself_ = true;
  return true;
}

void CudaMachine::end_batch(Loop& loop) {
  check(cudaStreamEndCapture(stream_, &loop.graph_), "record steps");
  check(cudaGraphInstantiate(&loop.executable_, loop.graph_, 0), "prepare a graph of steps");
  loop.repeats_itself_ = false;
}

}  // namespace sandsim::cuda
