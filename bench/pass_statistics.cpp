// Compiles passes with a Vulkan driver and prints what that driver says of them. Nothing is drawn:
// with RADV_FORCE_FAMILY in the environment RADV compiles for a card that is not there.
// bench/gpu_cost calls it.
//
//     pass_statistics < PASSES
//
// A pass is a line of words: its name, SPIR-V of a vertex and of a fragment shader, formats of the
// vertex attributes and of the targets (numbers of VkFormat by commas, - for none), and 1 if it has
// depth. Prints "name,stage,statistic,value" a line. Exits with 77 where there is no such driver.

// Structures have fields by their names, and functions of extensions are those of the driver.
#define VULKAN_HPP_NO_STRUCT_CONSTRUCTORS
#define VULKAN_HPP_DISPATCH_LOADER_DYNAMIC 1
#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>
#include <vulkan/vulkan.hpp>

VULKAN_HPP_DEFAULT_DISPATCH_LOADER_DYNAMIC_STORAGE

namespace {

constexpr std::uint32_t UNIFORMS = 8;  // binding, as bench/gpu_cost has it

struct Pass {
    std::string name, vertex, fragment, attributes, targets;
    bool has_depth = false;
};

struct NoDriver : std::runtime_error {
    using std::runtime_error::runtime_error;
};

std::vector<vk::Format> formats_of(const std::string& list) {
    std::vector<vk::Format> formats;
    std::istringstream in(list == "-" ? "" : list);
    for (std::string word; std::getline(in, word, ',');)
        formats.push_back(static_cast<vk::Format>(std::stoi(word)));
    return formats;
}

/// Lives until the program ends, as all that it makes.
vk::Device make_device() try {
    VULKAN_HPP_DEFAULT_DISPATCHER.init(vkGetInstanceProcAddr);
    const vk::ApplicationInfo application{.apiVersion = VK_API_VERSION_1_3};
    const vk::Instance instance = vk::createInstance({.pApplicationInfo = &application});
    VULKAN_HPP_DEFAULT_DISPATCHER.init(instance);
    const std::vector<vk::PhysicalDevice> cards = instance.enumeratePhysicalDevices();
    if (cards.empty()) throw NoDriver("Vulkan offers no device");

    const auto properties =
        cards[0]
            .getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    std::cout << properties.get<vk::PhysicalDeviceDriverProperties>().driverInfo << '\n';

    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue{.queueCount = 1, .pQueuePriorities = &priority};
    const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    const vk::StructureChain info(
        vk::DeviceCreateInfo{.queueCreateInfoCount = 1,
                             .pQueueCreateInfos = &queue,
                             .enabledExtensionCount = 1,
                             .ppEnabledExtensionNames = &extension},
        vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR{.pipelineExecutableInfo = true},
        vk::PhysicalDeviceVulkan13Features{.dynamicRendering = true});
    return cards[0].createDevice(info.get());
} catch (const vk::SystemError& reason) {
    throw NoDriver(std::string("no Vulkan driver gives statistics: ") + reason.what());
}

vk::PipelineShaderStageCreateInfo stage_of(vk::Device device,
                                           const std::string& file,
                                           vk::ShaderStageFlagBits stage) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (bytes.empty()) throw std::runtime_error(file + " cannot be read");
    std::vector<std::uint32_t> words(bytes.size() / 4);
    bytes.copy(reinterpret_cast<char*>(words.data()), 4 * words.size());
    const vk::ShaderModule module =
        device.createShaderModule({.codeSize = 4 * words.size(), .pCode = words.data()});
    return {.stage = stage, .module = module, .pName = "main"};
}

/// Textures at every binding before the block of uniforms. A shader that reads a binding which the
/// layout does not have can crash the driver.
vk::PipelineLayout make_layout(vk::Device device) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i <= UNIFORMS; ++i)
        bindings.push_back({.binding = i,
                            .descriptorType = i < UNIFORMS
                                                  ? vk::DescriptorType::eCombinedImageSampler
                                                  : vk::DescriptorType::eUniformBuffer,
                            .descriptorCount = 1,
                            .stageFlags = vk::ShaderStageFlagBits::eAllGraphics});
    const vk::DescriptorSetLayout set = device.createDescriptorSetLayout(
        {.bindingCount = UNIFORMS + 1, .pBindings = bindings.data()});
    return device.createPipelineLayout({.setLayoutCount = 1, .pSetLayouts = &set});
}

/// Triangles into the pass's targets, of both sides.
vk::Pipeline make_pipeline(vk::Device device, const Pass& pass) {
    std::vector<vk::VertexInputBindingDescription> arrays;
    std::vector<vk::VertexInputAttributeDescription> attributes;
    for (const vk::Format format : formats_of(pass.attributes)) {
        const auto i = static_cast<std::uint32_t>(arrays.size());
        arrays.push_back({.binding = i, .stride = 16});
        attributes.push_back({.location = i, .binding = i, .format = format});
    }
    const std::vector<vk::Format> targets = formats_of(pass.targets);
    const vk::PipelineRenderingCreateInfo rendering{
        .colorAttachmentCount = static_cast<std::uint32_t>(targets.size()),
        .pColorAttachmentFormats = targets.data(),
        .depthAttachmentFormat = pass.has_depth ? vk::Format::eD32Sfloat : vk::Format::eUndefined};
    const vk::PipelineShaderStageCreateInfo stages[] = {
        stage_of(device, pass.vertex, vk::ShaderStageFlagBits::eVertex),
        stage_of(device, pass.fragment, vk::ShaderStageFlagBits::eFragment)};
    const vk::PipelineVertexInputStateCreateInfo input{
        .vertexBindingDescriptionCount = static_cast<std::uint32_t>(arrays.size()),
        .pVertexBindingDescriptions = arrays.data(),
        .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size()),
        .pVertexAttributeDescriptions = attributes.data()};
    const vk::PipelineInputAssemblyStateCreateInfo triangles{
        .topology = vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{.viewportCount = 1, .scissorCount = 1};
    const vk::PipelineRasterizationStateCreateInfo raster{.lineWidth = 1};
    const vk::PipelineMultisampleStateCreateInfo samples;
    const vk::PipelineDepthStencilStateCreateInfo depth{.depthTestEnable = pass.has_depth,
                                                        .depthWriteEnable = pass.has_depth,
                                                        .depthCompareOp = vk::CompareOp::eGreater};
    using Channel = vk::ColorComponentFlagBits;
    const std::vector<vk::PipelineColorBlendAttachmentState> written(
        targets.size(), {.colorWriteMask = Channel::eR | Channel::eG | Channel::eB | Channel::eA});
    const vk::PipelineColorBlendStateCreateInfo blend{
        .attachmentCount = static_cast<std::uint32_t>(written.size()),
        .pAttachments = written.data()};
    const vk::DynamicState sizes[] = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{.dynamicStateCount = 2,
                                                     .pDynamicStates = sizes};
    const vk::GraphicsPipelineCreateInfo info{
        .pNext = &rendering,
        .flags = vk::PipelineCreateFlagBits::eCaptureStatisticsKHR,
        .stageCount = 2,
        .pStages = stages,
        .pVertexInputState = &input,
        .pInputAssemblyState = &triangles,
        .pViewportState = &viewport,
        .pRasterizationState = &raster,
        .pMultisampleState = &samples,
        .pDepthStencilState = &depth,
        .pColorBlendState = &blend,
        .pDynamicState = &dynamic,
        .layout = make_layout(device)};
    return device.createGraphicsPipeline({}, info).value;
}

void print_statistics(vk::Device device, vk::Pipeline pipeline, const std::string& name) {
    const auto stages = device.getPipelineExecutablePropertiesKHR({.pipeline = pipeline});
    for (std::uint32_t i = 0; i < stages.size(); ++i) {
        const bool is_fragment(stages[i].stages & vk::ShaderStageFlagBits::eFragment);
        for (const auto& statistic : device.getPipelineExecutableStatisticsKHR(
                 {.pipeline = pipeline, .executableIndex = i}))
            if (statistic.format == vk::PipelineExecutableStatisticFormatKHR::eUint64)
                std::cout << name << ',' << (is_fragment ? "fragment" : "vertex") << ','
                          << statistic.name << ',' << statistic.value.u64 << '\n';
    }
}

}  // namespace

int main() {
    try {
        vk::Device device = make_device();
        for (Pass pass; std::cin >> pass.name >> pass.vertex >> pass.fragment >> pass.attributes >>
                        pass.targets >> pass.has_depth;)
            print_statistics(device, make_pipeline(device, pass), pass.name);
    } catch (const NoDriver& reason) {
        std::cerr << reason.what() << '\n';
        return 77;
    } catch (const std::exception& reason) {
        std::cerr << reason.what() << '\n';
        return 1;
    }
    return 0;
}
