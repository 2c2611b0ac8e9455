//! An adapter of wgpu and one compute pass.

use std::io::Write;

use wgpu::util::{BufferInitDescriptor, DeviceExt};

/// An open device.
pub struct Adapter {
    /// What the driver says about itself.
    pub info: wgpu::AdapterInfo,
    device: wgpu::Device,
    queue: wgpu::Queue,
}

/// A function of the WGSL text: its name, the number of f32 arguments, and the f32 fields of its result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Kernel {
    /// Name in the text.
    pub name: String,
    /// Number of f32 arguments.
    pub arguments: usize,
    /// Names of the fields of a struct result; empty for a plain f32.
    pub fields: Vec<String>,
}

impl Kernel {
    /// Number of f32 in a row of results.
    pub fn results(&self) -> usize {
        self.fields.len().max(1)
    }

    /// The text with an entry point that runs this function on every row.
    fn shader(&self, wgsl: &str) -> String {
        let (arguments, results) = (self.arguments, self.results());
        let list: Vec<String> = (0..arguments)
            .map(|i| format!("parity_inputs[row * {arguments}u + {i}u]"))
            .collect();
        let stores: String = if self.fields.is_empty() {
            "    parity_outputs[row] = value;\n".to_owned()
        } else {
            let store = |(i, field)| format!("    parity_outputs[row * {results}u + {i}u] = value.{field};\n");
            self.fields.iter().enumerate().map(store).collect()
        };
        format!(
            "{wgsl}\n\
             @group(0) @binding(0) var<storage, read> parity_inputs: array<f32>;\n\
             @group(0) @binding(1) var<storage, read_write> parity_outputs: array<f32>;\n\
             @compute @workgroup_size(64) fn parity_entry(@builtin(global_invocation_id) id: vec3<u32>) {{\n\
             \x20   let row = id.x;\n\
             \x20   if row >= arrayLength(&parity_outputs) / {results}u {{ return; }}\n\
             \x20   let value = {}({});\n{stores}}}\n",
            self.name,
            list.join(", ")
        )
    }
}

impl Adapter {
    /// The fastest adapter there is, a software one if there is no other.
    pub fn open() -> Option<Adapter> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::VULKAN;
        let instance = wgpu::Instance::new(descriptor);
        let options = wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        };
        let adapter = pollster::block_on(instance.request_adapter(&options)).ok()?;
        let descriptor = wgpu::DeviceDescriptor {
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).ok()?;
        Some(Adapter {
            info: adapter.get_info(),
            device,
            queue,
        })
    }

    /// The open adapter, or None after a loud notice.
    ///
    /// # Panics
    /// Without an adapter, when the environment has `REQUIRE_GPU=1`.
    pub fn open_or_skip(test: &str) -> Option<Adapter> {
        let adapter = Adapter::open();
        if adapter.is_none() {
            let required = std::env::var("REQUIRE_GPU").is_ok_and(|value| value == "1");
            assert!(!required, "REQUIRE_GPU=1, but no Vulkan adapter was found for {test}");
            // Straight to the stream: the test harness would keep back what a macro prints in a test that passes.
            let _ = writeln!(std::io::stderr(), "{}", skipped(test));
        }
        adapter
    }

    /// Name, driver and version in one line.
    pub fn description(&self) -> String {
        let info = &self.info;
        format!(
            "{}, {} {}, {:?}",
            info.name, info.driver, info.driver_info, info.device_type
        )
    }

    /// Whether the adapter is a program on the CPU.
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// Runs `kernel` of the text on `rows`, row-major, and returns the results row-major.
    ///
    /// # Panics
    /// When the text does not compile or the device is lost: both are failures of the test.
    pub fn run(&self, wgsl: &str, kernel: &Kernel, rows: &[f32]) -> Vec<f32> {
        let count = rows.len() / kernel.arguments;
        let size = (count * kernel.results() * size_of::<f32>()) as u64;
        let device = &self.device;
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(&kernel.name),
            source: wgpu::ShaderSource::Wgsl(kernel.shader(wgsl).into()),
        });
        let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(&kernel.name),
            layout: None,
            module: &module,
            entry_point: Some("parity_entry"),
            compilation_options: Default::default(),
            cache: None,
        });
        let inputs = device.create_buffer_init(&BufferInitDescriptor {
            label: Some("inputs"),
            contents: bytemuck::cast_slice(rows),
            usage: wgpu::BufferUsages::STORAGE,
        });
        let buffer = |label, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let outputs = buffer("outputs", wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_SRC);
        let readable = buffer("readable", wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
        let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &pipeline.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry {
                    binding: 0,
                    resource: inputs.as_entire_binding(),
                },
                wgpu::BindGroupEntry {
                    binding: 1,
                    resource: outputs.as_entire_binding(),
                },
            ],
        });
        let mut encoder = device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_compute_pass(&Default::default());
            pass.set_pipeline(&pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.dispatch_workgroups(u32::try_from(count.div_ceil(64)).expect("fewer than 2^32 groups"), 1, 1);
        }
        encoder.copy_buffer_to_buffer(&outputs, 0, &readable, 0, size);
        self.queue.submit([encoder.finish()]);
        readable
            .slice(..)
            .map_async(wgpu::MapMode::Read, |done| done.expect("the results are mapped"));
        device
            .poll(wgpu::PollType::wait_indefinitely())
            .expect("the device finishes");
        let view = readable.slice(..).get_mapped_range().expect("the results are mapped");
        bytemuck::cast_slice(&view).to_vec()
    }
}

/// Notice that nothing was compared.
fn skipped(test: &str) -> String {
    let bar = "*".repeat(78);
    format!(
        "\n{bar}\n*** SKIPPED: {test}\n*** No Vulkan adapter was found: the WGSL text was NOT compared on a GPU API.\n\
         *** Debian: apt-get install --no-install-recommends mesa-vulkan-drivers\n\
         *** Set REQUIRE_GPU=1 to make this a failure.\n{bar}\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_skip_notice_is_loud_and_says_what_to_do() {
        let text = skipped("parity");
        assert!(text.lines().count() >= 6);
        assert!(text.contains("SKIPPED: parity") && text.contains("REQUIRE_GPU=1"));
    }

    #[test]
    fn the_entry_point_stores_every_field_of_a_row() {
        let kernel = Kernel {
            name: "f".into(),
            arguments: 2,
            fields: vec!["a".into(), "b".into()],
        };
        let text = kernel.shader("struct P { a: f32, b: f32 } fn f(x: f32, y: f32) -> P { return P(x, y); }");
        assert!(text.contains("f(parity_inputs[row * 2u + 0u], parity_inputs[row * 2u + 1u])"));
        assert!(text.contains("parity_outputs[row * 2u + 1u] = value.b;"));
        naga::front::wgsl::parse_str(&text).expect("valid WGSL");
    }
}
