//! Sweeps from and to Parquet: the same rows as with CSV for files of all kinds, and refusals.

use crate::support::{Scratch, Sweep, percuss, percuss_with_stdin, root};
use parquet::basic::{Compression, Encoding, LogicalType, Repetition, TimeUnit, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, FloatType, Int32Type, Int64Type};
use parquet::file::properties::{WriterProperties, WriterPropertiesBuilder, WriterVersion};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::record::Field;
use parquet::schema::types::Type;
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::{PositionFile, RowSource, StudyFile, Sweep as Prepared};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::cell::Cell;
use std::fs::File;
use std::sync::Arc;

const COUPLER: &str = "sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";
const STOP: &str = "sweep models/double_wishbone.urdf --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 \
                    --against chassis";

/// Values of a column of a test table.
#[derive(Clone, Debug)]
enum Values {
    Double(Vec<f64>),
    Float(Vec<f32>),
    Int(Vec<i32>, Option<LogicalType>),
    Long(Vec<i64>, Option<LogicalType>),
    Bool(Vec<bool>),
    Text(Vec<&'static str>),
}

/// Writes a table in row groups of the given size; a 0 in `nulls` marks a null.
fn write(
    path: &str,
    columns: &[(&str, Values)],
    optional: bool,
    nulls: Option<&[i16]>,
    group: usize,
    properties: WriterPropertiesBuilder,
) {
    let field = |(name, values): &(&str, Values)| {
        let (physical, logical) = match values {
            Values::Double(_) => (Physical::DOUBLE, None),
            Values::Float(_) => (Physical::FLOAT, None),
            Values::Int(_, logical) => (Physical::INT32, logical.clone()),
            Values::Long(_, logical) => (Physical::INT64, logical.clone()),
            Values::Bool(_) => (Physical::BOOLEAN, None),
            Values::Text(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let repetition = if optional { Repetition::OPTIONAL } else { Repetition::REQUIRED };
        let field = Type::primitive_type_builder(name, physical).with_repetition(repetition);
        Arc::new(field.with_logical_type(logical).build().expect("a column"))
    };
    let schema = Type::group_type_builder("table").with_fields(columns.iter().map(field).collect());
    let file = File::create(path).expect("a temporary file");
    let schema = Arc::new(schema.build().expect("a schema"));
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties.build())).expect("a writer");
    let rows = match &columns[0].1 {
        Values::Double(v) => v.len(),
        Values::Float(v) => v.len(),
        Values::Int(v, _) => v.len(),
        Values::Long(v, _) => v.len(),
        Values::Bool(v) => v.len(),
        Values::Text(v) => v.len(),
    };
    for first in (0..rows).step_by(group) {
        let range = first..(first + group).min(rows);
        let mut rows = writer.next_row_group().expect("a group");
        for (_, values) in columns {
            let levels: Vec<i16> = nulls.map_or(vec![1; range.len()], |nulls| nulls[range.clone()].to_vec());
            let kept = |i: &usize| levels[*i - first] > 0;
            let levels = optional.then_some(&levels[..]);
            let mut column = rows.next_column().expect("a column").expect("one more");
            macro_rules! put {
                ($kind:ty, $values:expr) => {{
                    let own: Vec<_> = range.clone().filter(kept).map(|i| $values[i].clone()).collect();
                    column.typed::<$kind>().write_batch(&own, levels, None)
                }};
            }
            match values {
                Values::Double(v) => put!(DoubleType, v),
                Values::Float(v) => put!(FloatType, v),
                Values::Int(v, _) => put!(Int32Type, v),
                Values::Long(v, _) => put!(Int64Type, v),
                Values::Bool(v) => put!(BoolType, v),
                Values::Text(v) => {
                    let v: Vec<ByteArray> = v.iter().map(|text| ByteArray::from(*text)).collect();
                    put!(ByteArrayType, v)
                }
            }
            .expect("values");
            column.close().expect("a column");
        }
        rows.close().expect("a group");
    }
    writer.close().expect("a file");
}

/// Crank angles that are exact in single precision.
fn angles(rows: usize) -> Vec<f64> {
    (0..rows).map(|i| (i % 400) as f64 / 64.0).collect()
}

fn csv(name: &str, values: &[f64]) -> String {
    values.iter().fold(format!("{name}\n"), |text, value| text + &format!("{value}\n"))
}

#[test]
fn parquet_rows_equal_csv_rows() {
    let scratch = Scratch::new("parquet-out");
    for (at, line) in [
        format!("{COUPLER} --vary crank_hinge=0:360deg:37"),
        // With unreachable rows and an estimate.
        format!("{STOP} --turning-normal --vary lower_arm_hinge=-0.2:2:23 --vary spin=0:1:3 --estimate spindle,upright:0,0,0:0,0,1"),
        // Several row groups.
        "sweep models/planar_2r.urdf --link outer --point 0.1,0.2,0 --normal 1,0.3,0 --random 150000 --seed 3".into(),
    ]
    .iter()
    .enumerate()
    {
        let (text, table) = (scratch.path(&format!("{at}.csv")), scratch.path(&format!("{at}.parquet")));
        let asked = percuss(&format!("{line} --output {text}"));
        assert_eq!(asked.code, 0, "{}", asked.stderr);
        let asked = percuss(&format!("{line} --output {table}"));
        assert_eq!(asked.code, 0, "{}", asked.stderr);
        let wanted = Sweep::read(&std::fs::read_to_string(text).expect("CSV"));
        let reader = SerializedFileReader::new(File::open(&table).expect("a file")).expect("Parquet");
        let description = reader.metadata();
        let names: Vec<&str> =
            description.file_metadata().schema().get_fields().iter().map(|field| field.name()).collect();
        assert_eq!(names, wanted.header);
        assert_eq!(description.num_row_groups(), wanted.rows.len().div_ceil(1 << 17));
        let heading = description.file_metadata().key_value_metadata().expect("metadata")[0].clone();
        assert_eq!(heading.key, "percuss.heading");
        let heading: serde_json::Value = serde_json::from_str(&heading.value.expect("a text")).expect("JSON");
        assert_eq!(heading["schema"], "percuss.sweep/2");
        let mut rows = 0;
        for (row, wanted) in reader.get_row_iter(None).expect("rows").zip(&wanted.rows) {
            for ((name, field), wanted) in row.expect("a row").get_column_iter().zip(wanted) {
                let same = match field {
                    Field::Null => wanted.is_empty(),
                    Field::Long(number) => number.to_string() == *wanted,
                    Field::Double(number) => wanted.parse() == Ok(*number),
                    Field::Str(text) => text == wanted,
                    Field::Bool(truth) => truth.to_string() == *wanted,
                    other => panic!("{name}: {other:?}"),
                };
                assert!(same, "{name}: {field:?}, {wanted}");
            }
            rows += 1;
        }
        assert_eq!(rows, wanted.rows.len());
    }
}

#[test]
fn every_kind_of_number_and_file_is_read_as_the_csv_is() {
    let scratch = Scratch::new("parquet-in");
    let angles = angles(2500);
    let whole: Vec<f64> = angles.iter().map(|angle| angle.floor()).collect();
    let ask = |name: &str, values: &[f64]| {
        let asked =
            percuss(&format!("{COUPLER} --input {}", scratch.write(name, &csv("crank_hinge", values))));
        assert_eq!(asked.code, 0, "{}", asked.stderr);
        asked.stdout
    };
    let (of_angles, of_whole) = (ask("angles.csv", &angles), ask("whole.csv", &whole));
    let ints: Vec<i32> = whole.iter().map(|x| *x as i32).collect();
    let longs: Vec<i64> = whole.iter().map(|x| *x as i64).collect();
    let kinds = [
        (Values::Double(angles.clone()), &of_angles),
        (Values::Float(angles.iter().map(|x| *x as f32).collect()), &of_angles),
        (Values::Int(ints.clone(), None), &of_whole),
        (Values::Int(ints.clone(), Some(LogicalType::integer(8, true))), &of_whole),
        (Values::Int(ints, Some(LogicalType::integer(32, false))), &of_whole),
        (Values::Long(longs.clone(), None), &of_whole),
        (Values::Long(longs, Some(LogicalType::integer(64, false))), &of_whole),
    ];
    let codecs = [
        Compression::UNCOMPRESSED,
        Compression::SNAPPY,
        Compression::ZSTD(Default::default()),
        Compression::LZ4_RAW,
        Compression::LZ4,
    ];
    let mut files = 0;
    for (at, (values, wanted)) in kinds.iter().enumerate() {
        let is_whole = matches!(values, Values::Int(..) | Values::Long(..));
        let encodings: &[Option<Encoding>] = if is_whole {
            &[None, Some(Encoding::PLAIN), Some(Encoding::DELTA_BINARY_PACKED)]
        } else {
            &[None, Some(Encoding::PLAIN), Some(Encoding::BYTE_STREAM_SPLIT)]
        };
        for (turn, encoding) in encodings.iter().enumerate() {
            for version in [WriterVersion::PARQUET_1_0, WriterVersion::PARQUET_2_0] {
                let codec = codecs[(files + at) % codecs.len()];
                let mut properties = WriterProperties::builder()
                    .set_writer_version(version)
                    .set_compression(codec)
                    .set_data_page_row_count_limit(700)
                    .set_write_batch_size(100)
                    .set_dictionary_enabled(encoding.is_none());
                if let Some(encoding) = encoding {
                    properties = properties.set_column_encoding("crank_hinge".into(), *encoding);
                }
                let path = scratch.path("table.parquet");
                let columns = [("crank_hinge", values.clone()), ("note", Values::Text(vec!["a"; 2500]))];
                write(&path, &columns, files % 2 == 0, None, [2500, 1000, 1][turn].max(37), properties);
                let asked = percuss(&format!("{COUPLER} --input {path} --ignore note"));
                assert_eq!(asked.code, 0, "{values:?} {encoding:?} {codec} {version:?}: {}", asked.stderr);
                assert!(asked.stdout == **wanted, "{encoding:?} {codec} {version:?}");
                files += 1;
            }
        }
    }
    // From the standard input too, with a unit.
    let path = scratch.path("degrees.parquet");
    let degrees: Vec<f64> = (0..10).map(|i| 36.0 * f64::from(i)).collect();
    let columns = [("crank_hinge [deg]", Values::Double(degrees.clone()))];
    write(&path, &columns, false, None, 4, WriterProperties::builder());
    let piped = percuss_with_stdin(&format!("{COUPLER} --input -"), &std::fs::read(path).expect("a file"));
    assert_eq!(piped.code, 0, "{}", piped.stderr);
    let text = scratch.write("degrees.csv", &csv("crank_hinge [deg]", &degrees));
    assert_eq!(piped.stdout, percuss(&format!("{COUPLER} --input {text}")).stdout);
}

/// A Parquet file is recognised by its first bytes; a CSV file whose first joint is named `PAR1` is no Parquet file.
#[test]
fn parquet_files_are_recognised_by_content() {
    let scratch = Scratch::new("parquet-content");
    let table = scratch.path("table.parquet");
    let columns = [("crank_hinge", Values::Double(angles(10)))];
    write(&table, &columns, false, None, 4, WriterProperties::builder());
    let expected = percuss(&format!("{COUPLER} --input {table}"));
    assert_eq!(expected.code, 0, "{}", expected.stderr);
    for name in ["table.csv", "table.CSV", "table.pq", "table"] {
        let path = scratch.path(name);
        std::fs::copy(&table, &path).expect("a copy");
        let outcome = percuss(&format!("{COUPLER} --input {path}"));
        assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
        assert_eq!(outcome.stdout, expected.stdout, "{name}");
    }
    let bytes = std::fs::read(&table).expect("a file");
    let cut = scratch.path("cut.csv");
    std::fs::write(&cut, &bytes[..bytes.len() / 2]).expect("a file");
    let encrypted = scratch.path("encrypted.csv");
    std::fs::write(&encrypted, b"PARE\x40\0\0\0................\x10\0\0\0PARE").expect("a file");
    let text = scratch.write("text.csv", "PAR1,PAR1 [deg]\n0,0\n");
    let other = scratch.write("text.pq", "crank_hinge\n0\n");
    for (path, words) in [
        (&cut, "it is not a complete Parquet file"),
        (&encrypted, "it is encrypted"),
        (&text, "no joint is named \"PAR1\""),
        (&other, "and it does not begin as a Parquet file"),
    ] {
        let outcome = percuss(&format!("{COUPLER} --input {path}"));
        assert_eq!(outcome.code, 2, "{path}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{path}: {}", outcome.stderr);
    }
}

#[test]
fn damaged_files_are_reported_with_their_position() {
    let scratch = Scratch::new("parquet-wrong");
    let path = scratch.path("path.parquet");
    let plain = WriterProperties::builder;
    let refused = |words: &str| {
        let asked = percuss(&format!("{COUPLER} --input {path}"));
        assert_eq!((asked.code, asked.stdout.as_str()), (2, ""), "{words}: {}", asked.stderr);
        assert!(asked.stderr.contains("error: --input: "), "{words}: {}", asked.stderr);
        assert!(asked.stderr.contains(words), "{words}: {}", asked.stderr);
    };
    let mut numbers = angles(3000);
    let all = |values: Values| vec![("crank_hinge", values)];
    let mut nulls = vec![1; 3000];
    nulls[2345] = 0;
    write(&path, &all(Values::Double(numbers.clone())), true, Some(&nulls), 1000, plain());
    refused("path.parquet: row 2345: column 1 (\"crank_hinge\"): the value is null; expected a number");
    numbers[1500] = f64::NAN;
    write(&path, &all(Values::Double(numbers.clone())), false, None, 1000, plain());
    refused("path.parquet: row 1500: column 1 (\"crank_hinge\"): \"NaN\" is not finite");
    numbers[1500] = 1e200;
    write(&path, &all(Values::Double(numbers.clone())), false, None, 1000, plain());
    refused("row 1500: joint \"crank_hinge\" is set to 1e200");
    for (values, words) in [
        (
            Values::Bool(vec![true]),
            "the column holds true and false; expected floating-point numbers or integers",
        ),
        (Values::Text(vec!["0.5"]), "the column holds text"),
        (
            Values::Long(vec![1], Some(LogicalType::timestamp(true, TimeUnit::NANOS))),
            "the column holds times of day and date",
        ),
        (Values::Int(vec![1], Some(LogicalType::Date)), "the column holds date values"),
    ] {
        write(&path, &all(values), false, None, 1, plain());
        refused(words);
    }
    let one = || Values::Double(vec![0.5]);
    write(&path, &[("crank_hinge", one()), ("tme", one())], false, None, 1, plain());
    refused("path.parquet: column 2 (\"tme\"): no joint is named \"tme\"");
    refused("or leave the column out (--ignore \"tme\")");
    write(&path, &[("crank_hinge", one()), ("crank_hinge", one())], false, None, 1, plain());
    refused("column 1 gives the same position");
    write(&path, &all(Values::Double(Vec::new())), false, None, 1, plain());
    refused("it has a header and no rows");
    nested(&path);
    refused("column 1 (\"crank_hinge\"): the column holds lists or records");
    for bytes in [&b""[..], b"PAR1", b"PAR1PAR1", b"crank_hinge\n0\n", b"PAR1\0\0\0\0\0\0\0\0PARE"] {
        std::fs::write(&path, bytes).expect("a temporary file");
        refused("path.parquet: it is ");
    }
    // Footer with a length larger than the file.
    std::fs::write(&path, b"PAR1\xff\xff\xff\x7fPAR1").expect("a temporary file");
    refused("longer than the file");
}

/// Table with a single column that is a record.
fn nested(path: &str) {
    let part = Type::primitive_type_builder("x", Physical::DOUBLE).with_repetition(Repetition::REQUIRED);
    let record = Type::group_type_builder("crank_hinge")
        .with_repetition(Repetition::REQUIRED)
        .with_fields(vec![Arc::new(part.build().expect("a column"))]);
    let schema =
        Type::group_type_builder("table").with_fields(vec![Arc::new(record.build().expect("a record"))]);
    let schema = Arc::new(schema.build().expect("a schema"));
    let file = File::create(path).expect("a temporary file");
    let mut writer = SerializedFileWriter::new(file, schema, Default::default()).expect("a writer");
    let mut rows = writer.next_row_group().expect("a group");
    let mut column = rows.next_column().expect("a column").expect("one more");
    column.typed::<DoubleType>().write_batch(&[0.5], None, None).expect("values");
    column.close().expect("a column");
    rows.close().expect("a group");
    writer.close().expect("a file");
}

/// Files with changed bytes and truncated files: an error or a result, and no panic inside the Parquet reader.
#[test]
fn damaged_files_are_refused() {
    // Counts panics of this thread only; other tests may panic.
    thread_local! {
        static PANICS: Cell<usize> = const { Cell::new(0) };
    }
    std::panic::set_hook(Box::new(|panic| {
        PANICS.set(PANICS.get() + 1);
        eprintln!("{panic}");
    }));
    let scratch = Scratch::new("parquet-damaged");
    let model = root().join("models/planar_2r.urdf");
    let text = format!(
        "[model]\npath = {:?}\n[contact]\nlink = \"outer\"\npoint = [0.1, 0.2, 0]\nnormal = [1, 0.3, 0]\n",
        model.display()
    );
    let study = StudyFile::load(&scratch.write("study.toml", &text), DEFAULT_MAX_SIZE).expect("a study");
    let question = study.question.as_ref().expect("a contact");
    let names: Vec<String> =
        study.model.mechanism.joints().iter().map(|joint| joint.name().to_owned()).collect();
    let path = scratch.path("table.parquet");
    let source = RowSource::File(PositionFile { path: path.clone(), ignore: Vec::new(), max_size: 1 << 20 });
    let mut random = StdRng::seed_from_u64(7);
    let (mut refused, mut read) = (0, 0);
    for turn in 0..8 {
        let properties = WriterProperties::builder()
            .set_writer_version([WriterVersion::PARQUET_1_0, WriterVersion::PARQUET_2_0][turn % 2])
            .set_compression([Compression::UNCOMPRESSED, Compression::SNAPPY][turn / 2 % 2])
            .set_dictionary_enabled(turn / 4 == 0)
            .set_data_page_row_count_limit(8)
            .set_write_batch_size(8);
        let numbers = angles(20);
        let columns: Vec<(&str, Values)> = names
            .iter()
            .enumerate()
            .map(|(at, name)| {
                let whole = numbers.iter().map(|x| *x as i64).collect();
                (
                    name.as_str(),
                    if at == 0 { Values::Double(numbers.clone()) } else { Values::Long(whole, None) },
                )
            })
            .collect();
        let properties = if turn >= 6 {
            properties.set_column_encoding(names[1].as_str().into(), Encoding::DELTA_BINARY_PACKED)
        } else {
            properties
        };
        write(&path, &columns, turn % 3 == 0, None, 12, properties);
        let good = std::fs::read(&path).expect("a file");
        assert!(Prepared::new(&study.model, question, source.clone()).is_ok());
        for _ in 0..600 {
            let mut bytes = good.clone();
            for _ in 0..random.random_range(1..4) {
                let at = random.random_range(0..bytes.len());
                bytes[at] = match random.random_range(0..3) {
                    0 => random.random(),
                    1 => bytes[at] ^ (1 << random.random_range(0..8)),
                    _ => [0, 0xff, 0x7f, 0x80][random.random_range(0..4)],
                };
            }
            if random.random_range(0..8) == 0 {
                // The beginning or the middle is lost; the reader needs the end to find the footer.
                let from = random.random_range(0..bytes.len() / 2);
                bytes.drain(4.min(from)..from);
            }
            std::fs::write(&path, bytes).expect("a temporary file");
            match Prepared::new(&study.model, question, source.clone()) {
                Ok(_) => read += 1,
                Err(_) => refused += 1,
            }
        }
    }
    assert!(refused > 1000 && read > 100, "{refused} {read}");
    assert_eq!(PANICS.get(), 0);
}
