#include "engine/gpu/specialise.h"

#include "engine/core/check.h"

#include <spirv-tools/optimizer.hpp>

#include <string>
#include <unordered_map>

namespace manylight::gpu {

std::vector<uint32_t> specialised(std::span<const uint32_t> words, const ConstantValues& values) {
    std::unordered_map<uint32_t, std::vector<uint32_t>> ofConstants;
    for (const auto& [constant, value] : values) ofConstants[constant] = {value};

    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    std::string messages;
    optimizer.SetMessageConsumer([&](spv_message_level_t level, const char*, const spv_position_t&, const char* text) {
        if (level <= SPV_MSG_ERROR) messages += std::string(" ") + text;
    });
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(ofConstants))
        .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
    spvtools::OptimizerOptions options;
    options.set_run_validator(false);
    std::vector<uint32_t> result;
    if (!optimizer.Run(words.data(), words.size(), &result, options))
        throw BugError("specialising a shader:" + messages);
    return result;
}

}  // namespace manylight::gpu
