/* Sizes and byte offsets in WebAssembly of the structs of wasm/surfpath.h and wasm/surface.h, struct_bytes and struct_field: constants, which the bundler writes
 * as numbers. A test compares them with what the compiler asserts. */

export const sp_surface_bytes = 56;
export const sp_surface_jet = 0;
export const sp_surface_value = 4;
export const sp_surface_kind = 8;
export const sp_surface_metric = 12;
export const sp_surface_lower = 16;
export const sp_surface_upper = 32;
export const sp_surface_extent = 48;

export const sp_options_bytes = 32;
export const sp_options_tolerance = 0;
export const sp_options_gradient_tolerance = 8;
export const sp_options_algorithm = 16;
export const sp_options_point_count = 20;
export const sp_options_max_iterations = 24;
export const sp_options_record = 28;

export const sp_request_bytes = 80;
export const sp_request_from = 0;
export const sp_request_to = 24;
export const sp_request_start = 48;
export const sp_request_start_count = 52;
export const sp_request_passage = 56;

export const sp_passage_bytes = 24;
export const sp_passage_way = 0;
export const sp_passage_edge = 4;
export const sp_passage_beyond = 8;
export const sp_passage_turn = 16;

export const sp_iterate_bytes = 32;
export const sp_iterate_energy = 0;
export const sp_iterate_gradient_norm = 8;
export const sp_iterate_decrement = 16;
export const sp_iterate_step = 24;

export const sp_result_bytes = 136;
export const sp_result_length = 0;
export const sp_result_length_error = 8;
export const sp_result_energy = 16;
export const sp_result_gradient_norm = 24;
export const sp_result_rounding = 32;
export const sp_result_pull = 40;
export const sp_result_points = 88;
export const sp_result_parameters = 92;
export const sp_result_history = 96;
export const sp_result_record = 100;
export const sp_result_status = 104;
export const sp_result_iterations = 108;
export const sp_result_work = 112;
export const sp_result_index = 116;
export const sp_result_touches_boundary = 120;
export const sp_result_history_count = 124;
export const sp_result_crosses_singularity = 128;

export const sp_trace_request_bytes = 56;
export const sp_trace_request_from = 0;
export const sp_trace_request_direction = 24;
export const sp_trace_request_length = 48;

export const sp_trace_options_bytes = 16;
export const sp_trace_options_tolerance = 0;
export const sp_trace_options_point_count = 8;
export const sp_trace_options_max_steps = 12;

export const sp_trace_result_bytes = 96;
export const sp_trace_result_length = 0;
export const sp_trace_result_length_error = 8;
export const sp_trace_result_conjugate = 16;
export const sp_trace_result_velocity = 24;
export const sp_trace_result_turn_error = 48;
export const sp_trace_result_field = 56;
export const sp_trace_result_points = 72;
export const sp_trace_result_parameters = 76;
export const sp_trace_result_status = 80;
export const sp_trace_result_steps = 84;
export const sp_trace_result_touches_boundary = 88;
export const sp_trace_result_normal = 92;

export const sp_arena_bytes = 12;
export const sp_arena_base = 0;
export const sp_arena_size = 4;
export const sp_arena_used = 8;

export const sp_mesh_bytes = 20;
export const sp_mesh_positions = 0;
export const sp_mesh_normals = 4;
export const sp_mesh_indices = 8;
export const sp_mesh_vertex_count = 12;
export const sp_mesh_triangle_count = 16;

export const sp_graph_options_bytes = 80;
export const sp_graph_options_box = 0;
export const sp_graph_options_cell = 48;
export const sp_graph_options_resolution = 56;
export const sp_graph_options_loose = 60;
export const sp_graph_options_reach = 64;
export const sp_graph_options_level = 72;

export const sp_graph_bytes = 136;
export const sp_graph_spacing = 0;
export const sp_graph_vertex_count = 36;
export const sp_graph_unique = 44;
export const sp_graph_singular = 48;
export const sp_graph_resolved = 88;
export const sp_graph_coarse = 92;
export const sp_graph_form = 96;

export const sp_graph_answer_bytes = 24;
export const sp_graph_answer_distance = 0;
export const sp_graph_answer_places = 8;
export const sp_graph_answer_candidate_count = 12;
export const sp_graph_answer_point_count = 16;

export const sp_field_request_bytes = 40;
export const sp_field_request_places = 24;
export const sp_field_request_lengths = 28;
export const sp_field_request_count = 32;
