// Compiles passes with a Vulkan driver and prints what that driver says of them. Nothing is drawn:
// with RADV_FORCE_FAMILY in the environment RADV compiles for a card that is not there.
// bench/gpu_cost calls it.
//
//     pass_statistics < PASSES
//
// A pass is a line of words: its name, SPIR-V of a vertex and of a fragment shader, formats of the
// vertex attributes and of the targets (numbers of VkFormat by commas, - for none), and the count
// of textures. Prints "name,stage,statistic,value" a line. Exits with 77 where there is no such
// driver.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Pass {
    std::string name, vertex, fragment, attributes, targets;
    std::uint32_t texture_count = 0;
    bool has_depth = false;
};

struct NoDriver : std::runtime_error {
    using std::runtime_error::runtime_error;
};

void check(VkResult result, const std::string& what) {
    if (result != VK_SUCCESS)
        throw std::runtime_error(what + ": VkResult " + std::to_string(result));
}

std::vector<VkFormat> formats_of(const std::string& list) {
    std::vector<VkFormat> formats;
    std::istringstream in(list == "-" ? "" : list);
    for (std::string word; std::getline(in, word, ',');)
        formats.push_back(static_cast<VkFormat>(std::stoi(word)));
    return formats;
}

/// Lives until the program ends, as all that it makes.
VkDevice make_device() {
    const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                        .apiVersion = VK_API_VERSION_1_3};
    const VkInstanceCreateInfo instance_info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                             .pApplicationInfo = &application};
    VkInstance instance = nullptr;
    if (vkCreateInstance(&instance_info, nullptr, &instance) != VK_SUCCESS)
        throw NoDriver("there is no Vulkan driver");
    std::uint32_t count = 1;
    VkPhysicalDevice card = nullptr;
    if (vkEnumeratePhysicalDevices(instance, &count, &card) < 0 || count == 0)
        throw NoDriver("Vulkan offers no device");

    VkPhysicalDeviceDriverProperties driver{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
    VkPhysicalDeviceProperties2 properties{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2,
                                           .pNext = &driver};
    vkGetPhysicalDeviceProperties2(card, &properties);
    std::cout << driver.driverInfo << '\n';

    const float priority = 1;
    const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                        .queueCount = 1,
                                        .pQueuePriorities = &priority};
    VkPhysicalDeviceVulkan13Features rendering{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES,
        .dynamicRendering = VK_TRUE};
    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR statistics{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR,
        .pNext = &rendering,
        .pipelineExecutableInfo = VK_TRUE};
    const char* extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                  .pNext = &statistics,
                                  .queueCreateInfoCount = 1,
                                  .pQueueCreateInfos = &queue,
                                  .enabledExtensionCount = 1,
                                  .ppEnabledExtensionNames = &extension};
    VkDevice device = nullptr;
    if (vkCreateDevice(card, &info, nullptr, &device) != VK_SUCCESS)
        throw NoDriver("the Vulkan driver gives no statistics");
    return device;
}

VkPipelineShaderStageCreateInfo stage_of(VkDevice device,
                                         const std::string& file,
                                         VkShaderStageFlagBits stage) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    if (bytes.empty()) throw std::runtime_error(file + " cannot be read");
    std::vector<std::uint32_t> words(bytes.size() / 4);
    bytes.copy(reinterpret_cast<char*>(words.data()), 4 * words.size());
    const VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .codeSize = 4 * words.size(),
                                        .pCode = words.data()};
    VkShaderModule module = nullptr;
    check(vkCreateShaderModule(device, &info, nullptr, &module), file);
    return {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
            .stage = stage,
            .module = module,
            .pName = "main"};
}

/// Textures, and then one block of uniforms: as glslangValidator numbers them.
VkPipelineLayout make_layout(VkDevice device, std::uint32_t texture_count) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i <= texture_count; ++i)
        bindings.push_back({.binding = i,
                            .descriptorType = i < texture_count
                                                  ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                                  : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                            .descriptorCount = 1,
                            .stageFlags = VK_SHADER_STAGE_ALL_GRAPHICS});
    const VkDescriptorSetLayoutCreateInfo set_info{
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
        .bindingCount = texture_count + 1,
        .pBindings = bindings.data()};
    VkDescriptorSetLayout set = nullptr;
    check(vkCreateDescriptorSetLayout(device, &set_info, nullptr, &set), "a set of textures");
    const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                          .setLayoutCount = 1,
                                          .pSetLayouts = &set};
    VkPipelineLayout layout = nullptr;
    check(vkCreatePipelineLayout(device, &info, nullptr, &layout), "a layout");
    return layout;
}

/// Triangles into the pass's targets, of both sides.
VkPipeline make_pipeline(VkDevice device, const Pass& pass) {
    std::vector<VkVertexInputBindingDescription> arrays;
    std::vector<VkVertexInputAttributeDescription> attributes;
    for (const VkFormat format : formats_of(pass.attributes)) {
        const auto i = static_cast<std::uint32_t>(arrays.size());
        arrays.push_back({.binding = i, .stride = 16});
        attributes.push_back({.location = i, .binding = i, .format = format});
    }
    const std::vector<VkFormat> targets = formats_of(pass.targets);
    const VkPipelineRenderingCreateInfo rendering{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO,
        .colorAttachmentCount = static_cast<std::uint32_t>(targets.size()),
        .pColorAttachmentFormats = targets.data(),
        .depthAttachmentFormat = pass.has_depth ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_UNDEFINED};
    const VkPipelineShaderStageCreateInfo stages[] = {
        stage_of(device, pass.vertex, VK_SHADER_STAGE_VERTEX_BIT),
        stage_of(device, pass.fragment, VK_SHADER_STAGE_FRAGMENT_BIT)};
    const VkPipelineVertexInputStateCreateInfo input{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO,
        .vertexBindingDescriptionCount = static_cast<std::uint32_t>(arrays.size()),
        .pVertexBindingDescriptions = arrays.data(),
        .vertexAttributeDescriptionCount = static_cast<std::uint32_t>(attributes.size()),
        .pVertexAttributeDescriptions = attributes.data()};
    const VkPipelineInputAssemblyStateCreateInfo triangles{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO,
        .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST};
    const VkPipelineViewportStateCreateInfo viewport{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO,
        .viewportCount = 1,
        .scissorCount = 1};
    const VkPipelineRasterizationStateCreateInfo raster{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO, .lineWidth = 1};
    const VkPipelineMultisampleStateCreateInfo samples{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO,
        .rasterizationSamples = VK_SAMPLE_COUNT_1_BIT};
    const VkPipelineDepthStencilStateCreateInfo depth{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO,
        .depthTestEnable = pass.has_depth,
        .depthWriteEnable = pass.has_depth,
        .depthCompareOp = VK_COMPARE_OP_GREATER};
    const std::vector<VkPipelineColorBlendAttachmentState> written(targets.size(),
                                                                   {.colorWriteMask = 15});
    const VkPipelineColorBlendStateCreateInfo blend{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO,
        .attachmentCount = static_cast<std::uint32_t>(written.size()),
        .pAttachments = written.data()};
    const VkDynamicState sizes[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    const VkPipelineDynamicStateCreateInfo dynamic{
        .sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO,
        .dynamicStateCount = 2,
        .pDynamicStates = sizes};
    const VkGraphicsPipelineCreateInfo info{
        .sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO,
        .pNext = &rendering,
        .flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR,
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
        .layout = make_layout(device, pass.texture_count)};
    VkPipeline pipeline = nullptr;
    check(vkCreateGraphicsPipelines(device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          pass.name);
    return pipeline;
}

template <class Function>
Function function_of(VkDevice device, const char* name) {
    return reinterpret_cast<Function>(vkGetDeviceProcAddr(device, name));
}

void print_statistics(VkDevice device, VkPipeline pipeline, const std::string& name) {
    const auto properties_of = function_of<PFN_vkGetPipelineExecutablePropertiesKHR>(
        device, "vkGetPipelineExecutablePropertiesKHR");
    const auto statistics_of = function_of<PFN_vkGetPipelineExecutableStatisticsKHR>(
        device, "vkGetPipelineExecutableStatisticsKHR");
    const VkPipelineInfoKHR of_pipeline{.sType = VK_STRUCTURE_TYPE_PIPELINE_INFO_KHR,
                                        .pipeline = pipeline};
    std::uint32_t stage_count = 0;
    check(properties_of(device, &of_pipeline, &stage_count, nullptr), name);
    std::vector<VkPipelineExecutablePropertiesKHR> stages(
        stage_count, {.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_PROPERTIES_KHR});
    check(properties_of(device, &of_pipeline, &stage_count, stages.data()), name);
    for (std::uint32_t stage = 0; stage < stage_count; ++stage) {
        const VkPipelineExecutableInfoKHR of_stage{
            .sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR,
            .pipeline = pipeline,
            .executableIndex = stage};
        std::uint32_t count = 0;
        check(statistics_of(device, &of_stage, &count, nullptr), name);
        std::vector<VkPipelineExecutableStatisticKHR> found(
            count, {.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR});
        check(statistics_of(device, &of_stage, &count, found.data()), name);
        const char* word =
            stages[stage].stages & VK_SHADER_STAGE_FRAGMENT_BIT ? "fragment" : "vertex";
        for (const VkPipelineExecutableStatisticKHR& statistic : found)
            if (statistic.format == VK_PIPELINE_EXECUTABLE_STATISTIC_FORMAT_UINT64_KHR)
                std::cout << name << ',' << word << ',' << statistic.name << ','
                          << statistic.value.u64 << '\n';
    }
}

}  // namespace

int main() {
    try {
        VkDevice device = make_device();
        for (Pass pass; std::cin >> pass.name >> pass.vertex >> pass.fragment >> pass.attributes >>
                        pass.targets >> pass.texture_count >> pass.has_depth;)
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
