// A frame's launches as one CUDA graph. The sample's number is an argument of kernels, so each frame is
// captured and the graph of the frame before updated with it.
#pragma once

#include "backends/cuda_check.cuh"

namespace ctpbench {

class FrameGraph {
public:
    FrameGraph() = default;
    FrameGraph(const FrameGraph&) = delete;
    FrameGraph& operator=(const FrameGraph&) = delete;
    ~FrameGraph() {
        if (graph_ != nullptr) cudaGraphExecDestroy(graph_);
    }

    // Captures what launch() launches into the stream, then launches that at once.
    template <class F>
    void run(cudaStream_t stream, F&& launch) {
        check_cuda(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), "capturing a frame");
        launch();
        cudaGraph_t captured = nullptr;
        check_cuda(cudaStreamEndCapture(stream, &captured), "capturing a frame");
        cudaGraphExecUpdateResultInfo result;
        if (graph_ == nullptr || cudaGraphExecUpdate(graph_, captured, &result) != cudaSuccess) {
            cudaGetLastError();
            if (graph_ != nullptr) check_cuda(cudaGraphExecDestroy(graph_), "replacing a graph");
            graph_ = nullptr;
            check_cuda(cudaGraphInstantiate(&graph_, captured, 0), "making a graph of a frame");
        }
        check_cuda(cudaGraphDestroy(captured), "making a graph of a frame");
        check_cuda(cudaGraphLaunch(graph_, stream), "launching a frame's graph");
    }

private:
    cudaGraphExec_t graph_ = nullptr;
};

}  // namespace ctpbench
